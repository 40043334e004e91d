#include <bit>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/mapped_file.hpp"
#include "io/mesh/stl_format.hpp"
#include "io/mesh/weld_points.hpp"
#include "io/text_parts.hpp"

namespace quarry {
namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is little-endian");

// The facets of a binary file.
class StlFacets {
 public:
  explicit StlFacets(std::string_view bytes) : bytes_(bytes) {}

  // As the header announces them: 0 for a file that has no whole header.
  [[nodiscard]] std::size_t announced() const {
    if (bytes_.size() < kStlHeaderBytes) return 0;
    std::uint32_t count = 0;
    std::memcpy(&count, bytes_.data() + kStlHeaderBytes - sizeof(count), sizeof(count));
    return count;
  }
  [[nodiscard]] std::size_t whole_size() const { return kStlHeaderBytes + kStlFacetBytes * announced(); }

  [[nodiscard]] static std::size_t byte_of(std::size_t corner) {
    return kStlHeaderBytes + kStlFacetBytes * (corner / 3) + 3 * sizeof(float) * (1 + corner % 3);
  }
  // Adding 0 makes a positive zero of a negative one.
  [[nodiscard]] Vec3 point(std::size_t corner) const {
    float p[3];
    std::memcpy(p, bytes_.data() + byte_of(corner), sizeof(p));
    return {p[0] + 0.0, p[1] + 0.0, p[2] + 0.0};
  }

 private:
  std::string_view bytes_;
};

ReadCells read_binary(const std::string& path, const StlFacets& facets) {
  constexpr std::size_t kFacetsInPart = 16384;
  const std::size_t count = facets.announced();
  read_parts((count + kFacetsInPart - 1) / kFacetsInPart, [&](std::size_t part) {
    const std::size_t end = 3 * std::min(count, (part + 1) * kFacetsInPart);
    for (std::size_t i = 3 * part * kFacetsInPart; i < end; ++i) {
      const Vec3 p = facets.point(i);
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        throw Error(ErrorKind::kInput, fmt::format("{}: byte {}: a coordinate is not a finite number", path,
                                                   StlFacets::byte_of(i)));
    }
  });
  ReadCells cells = weld_triangles(3 * count, [&](std::size_t i) { return facets.point(i); });
  cells.regions.assign(count, 0);
  return cells;
}

// Blanks, then "solid" in either case of letters, and no zero byte near the start.
bool looks_like_text(std::string_view text) {
  constexpr std::size_t kLookedAt = 512;
  const std::string_view start = text.substr(0, kLookedAt);
  const std::size_t word = start.find_first_not_of(" \t\r\n");
  return word != std::string_view::npos && same_stl_word(start.substr(word).substr(0, 5), "solid") &&
         start.find('\0') == std::string_view::npos;
}

}  // namespace

ReadCells read_stl(const std::string& path) {
  const MappedFile file(path);
  const StlFacets facets(file.text());
  const std::size_t size = file.text().size();
  if (size >= kStlHeaderBytes && size == facets.whole_size()) return read_binary(path, facets);
  if (looks_like_text(file.text())) return read_stl_text(path, file.text());
  if (size < kStlHeaderBytes)
    throw Error(
        ErrorKind::kInput,
        fmt::format("{}: {} bytes are no STL: the text form starts with \"solid\", the binary form has "
                    "{} bytes or more",
                    path, size, kStlHeaderBytes));
  throw Error(
      ErrorKind::kInput,
      fmt::format("{}: byte {}: the header announces {} facets, which make a file of {} bytes, not {}", path,
                  kStlHeaderBytes - 4, facets.announced(), facets.whole_size(), size));
}

}  // namespace quarry
