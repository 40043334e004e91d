// A wavy surface of a million triangles, in files of every format that surfaces come in.
#pragma once

#include <filesystem>
#include <string>

namespace quarry::bench {

// The files lie in a folder of their own, which goes with the object.
class SurfaceFiles {
 public:
  static constexpr std::size_t kTriangles = 2 * 707 * 707;

  SurfaceFiles();
  ~SurfaceFiles();
  SurfaceFiles(const SurfaceFiles&) = delete;
  SurfaceFiles& operator=(const SurfaceFiles&) = delete;

  // binary.ply, text.ply, binary.stl, text.stl, text.obj or text.off.
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

 private:
  std::filesystem::path folder_;
};

}  // namespace quarry::bench
