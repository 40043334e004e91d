// A folder for files that go when the job is done.
#pragma once

#include <string>

namespace quarry {

class ScratchFolder {
 public:
  // In the system's folder for such files (TMPDIR). Throws Error(kOutput) with the system's reason.
  ScratchFolder();
  // Removes it with all that is in it.
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] std::string file(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

}  // namespace quarry
