#include "bench/surface_files.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "engine/base/random.hpp"
#include "io/atomic_file.hpp"

namespace quarry::bench {
namespace {

constexpr std::uint32_t kSide = 708;

struct Surface {
  std::vector<std::array<float, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

Surface make_surface() {
  Surface surface;
  for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
    const std::uint32_t column = i % kSide;
    const std::uint32_t row = i / kSide;
    const double x = column + 0.5 * uniform01(1, i);
    const double y = row + 0.5 * uniform01(2, i);
    surface.points.push_back({static_cast<float>(x), static_cast<float>(y),
                              static_cast<float>(20 * std::sin(0.02 * x) * std::cos(0.03 * y))});
  }
  for (std::uint32_t j = 0; j + 1 < kSide; ++j)
    for (std::uint32_t i = 0; i + 1 < kSide; ++i) {
      const std::uint32_t a = j * kSide + i;
      surface.triangles.push_back({a, a + 1, a + kSide + 1});
      surface.triangles.push_back({a, a + kSide + 1, a + kSide});
    }
  return surface;
}

class Text {
 public:
  template <class... Values>
  void print(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
  }
  template <class Value>
  void bytes(const Value& value) {
    text_.append(reinterpret_cast<const char*>(&value), sizeof(Value));
  }
  void points(const Surface& surface, const char* key) {
    for (const auto& p : surface.points) print("{}{} {} {}\n", key, p[0], p[1], p[2]);
  }
  void triangles(const Surface& surface, const char* key, std::uint32_t first) {
    for (const auto& t : surface.triangles)
      print("{} {} {} {}\n", key, t[0] + first, t[1] + first, t[2] + first);
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

Text ply_header(const Surface& surface, const char* format) {
  Text text;
  text.print(
      "ply\nformat {} 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      format, surface.points.size(), surface.triangles.size());
  return text;
}

Text text_ply(const Surface& surface) {
  Text text = ply_header(surface, "ascii");
  text.points(surface, "");
  text.triangles(surface, "3", 0);
  return text;
}

Text binary_ply(const Surface& surface) {
  Text text = ply_header(surface, "binary_little_endian");
  for (const auto& p : surface.points) text.bytes(p);
  for (const auto& t : surface.triangles) {
    text.bytes(std::uint8_t{3});
    text.bytes(t);
  }
  return text;
}

Text text_obj(const Surface& surface) {
  Text text;
  text.points(surface, "v ");
  text.triangles(surface, "f", 1);
  return text;
}

Text text_off(const Surface& surface) {
  Text text;
  text.print("OFF\n{} {} 0\n", surface.points.size(), surface.triangles.size());
  text.points(surface, "");
  text.triangles(surface, "3", 0);
  return text;
}

Text text_stl(const Surface& surface) {
  Text text;
  text.print("solid wave\n");
  for (const auto& t : surface.triangles) {
    text.print("facet normal 0 0 1\n  outer loop\n");
    for (const std::uint32_t v : t)
      text.print("    vertex {} {} {}\n", surface.points[v][0], surface.points[v][1], surface.points[v][2]);
    text.print("  endloop\nendfacet\n");
  }
  text.print("endsolid wave\n");
  return text;
}

Text binary_stl(const Surface& surface) {
  Text text;
  text.print("{:80}", "wave");
  text.bytes(static_cast<std::uint32_t>(surface.triangles.size()));
  for (const auto& t : surface.triangles) {
    text.bytes(std::array<float, 3>{0, 0, 1});
    for (const std::uint32_t v : t) text.bytes(surface.points[v]);
    text.bytes(std::uint16_t{0});
  }
  return text;
}

}  // namespace

SurfaceFiles::SurfaceFiles() {
  std::string name = (std::filesystem::temp_directory_path() / "quarry_bench_XXXXXX").string();
  folder_ = ::mkdtemp(name.data());
  const Surface surface = make_surface();
  write_file(path("text.ply"), text_ply(surface).text());
  write_file(path("binary.ply"), binary_ply(surface).text());
  write_file(path("text.obj"), text_obj(surface).text());
  write_file(path("text.off"), text_off(surface).text());
  write_file(path("text.stl"), text_stl(surface).text());
  write_file(path("binary.stl"), binary_stl(surface).text());
}

SurfaceFiles::~SurfaceFiles() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

}  // namespace quarry::bench
