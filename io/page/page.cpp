#include "io/page/page.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/atomic_file.hpp"
#include "io/page/base64.hpp"
#include "io/page/resources.hpp"
#include "io/picture/colour.hpp"
#include "io/xml_text.hpp"

namespace quarry {
namespace {

constexpr std::uint32_t kNoCorner = std::numeric_limits<std::uint32_t>::max();

template <class Value>
std::string packed(const std::vector<Value>& values) {
  return base64(std::as_bytes(std::span(values)));
}

void add_colour(std::vector<std::uint8_t>& bytes, Colour colour) {
  for (const double part : {colour.red, colour.green, colour.blue})
    bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * part)));
}

// Edge entities, and the sides without a face across that are none.
std::vector<std::uint32_t> feature_ends(const Mesh& mesh) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  const auto add = [&](VertexId a, VertexId b) { edges.push_back(std::minmax(a.value(), b.value())); };
  for (const EdgeId e : mesh.edges()) {
    const auto [a, b] = mesh.edge_ends(e);
    add(a, b);
  }
  for (const FaceId f : mesh.faces())
    for (int k = 0; mesh.alive(f) && k < mesh.corner_count(f); ++k)
      if (const SideId s(f, k); !mesh.neighbour(s).valid()) add(mesh.origin(s), mesh.target(s));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::vector<std::uint32_t> ends;
  for (const auto& [a, b] : edges) ends.insert(ends.end(), {a, b});
  return ends;
}

// What viewer/viewer.mjs reads: JSON, with arrays in base64. Points are told from the middle of the mesh, in
// halves of its diagonal, so that large coordinates keep their digits.
std::string mesh_json(const Mesh& mesh, const PageOptions& options) {
  const Box3 box = mesh.box3();
  const Vec3 center = 0.5 * (box.low + box.high);
  const double radius = std::max(0.5 * length(box.high - box.low), std::numeric_limits<double>::min());
  std::vector<float> points;
  points.reserve(3 * mesh.vertex_slots());
  for (const VertexId v : mesh.vertices()) {
    const Vec3 p = mesh.alive(v) ? (1 / radius) * (mesh.point3(v) - center) : Vec3();
    for (const double x : {p.x, p.y, p.z}) points.push_back(static_cast<float>(x));
  }
  const auto region = mesh.find_tag<FaceId, std::int32_t>("region");
  std::vector<std::uint32_t> faces;
  std::vector<float> quality;
  std::vector<std::uint8_t> quality_colours, region_colours;
  for (const FaceId f : mesh.faces()) {
    if (!mesh.alive(f)) continue;
    for (int k = 0; k < 4; ++k)
      faces.push_back(k < mesh.corner_count(f) ? mesh.corner(f, k).value() : kNoCorner);
    quality.push_back(static_cast<float>(options.quality[f.value()]));
    add_colour(quality_colours, quality_colour(options.quality[f.value()]));
    add_colour(region_colours, region_colour(region.valid() ? region[f] : 0));
  }
  return fmt::format(
      R"({{"planar":{},"center":[{},{},{}],"radius":{},"points":"{}","faces":"{}","quality":"{}",)"
      R"("quality_colours":"{}","region_colours":"{}","features":"{}"}})",
      mesh.planar(), center.x, center.y, center.z, radius, packed(points), packed(faces), packed(quality),
      packed(quality_colours), packed(region_colours), packed(feature_ends(mesh)));
}

std::string figure_rows(const PageOptions& options) {
  std::string rows;
  for (const PageFigure& figure : options.figures)
    rows +=
        fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", escape_xml(figure.name), escape_xml(figure.value));
  return rows;
}

// Bars as high as the share of the largest count; a bar that is not zero can be seen.
std::string histogram_drawing(const PageHistogram& histogram) {
  constexpr double kWidth = 280, kHeight = 90, kFoot = 12;
  const std::size_t bins = std::max<std::size_t>(histogram.counts.size(), 1);
  const double bar = kWidth / static_cast<double>(bins);
  const std::size_t largest =
      histogram.counts.empty() ? 0 : *std::max_element(histogram.counts.begin(), histogram.counts.end());
  std::string svg = fmt::format("<h2>{}</h2>\n<svg viewBox=\"0 0 {} {}\">", escape_xml(histogram.name),
                                kWidth, kHeight + kFoot);
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    const std::size_t count = histogram.counts[i];
    if (count == 0) continue;
    const double height = std::max(1.0, kHeight * static_cast<double>(count) / static_cast<double>(largest));
    svg += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
        "fill=\"#7fa8c9\"><title>{}</title></rect>",
        static_cast<double>(i) * bar + 0.5, kHeight - height, bar - 1, height, count);
  }
  svg += fmt::format(
      "<text x=\"0\" y=\"{0}\">{1:g}</text><text x=\"{2}\" y=\"{0}\" "
      "text-anchor=\"end\">{3:g}</text></svg>\n",
      kHeight + kFoot - 2, histogram.low, kWidth, histogram.high);
  return svg;
}

// The template with each {{name}} replaced.
std::string filled(std::string_view text,
                   const std::vector<std::pair<std::string_view, std::string>>& values) {
  std::string out;
  while (true) {
    const std::size_t begin = text.find("{{");
    out += text.substr(0, begin);
    if (begin == std::string_view::npos) return out;
    const std::size_t end = text.find("}}", begin);
    const std::string_view name = text.substr(begin + 2, end - begin - 2);
    const auto value =
        std::find_if(values.begin(), values.end(), [&](const auto& v) { return v.first == name; });
    if (value == values.end()) throw Error(ErrorKind::kBug, fmt::format("page.html: no value for {}", name));
    out += value->second;
    text.remove_prefix(end + 2);
  }
}

}  // namespace

bool is_page(const std::string& path) { return std::filesystem::path(path).extension() == ".html"; }

void check_page_extension(const std::string& path) {
  if (!is_page(path))
    throw Error(ErrorKind::kUsage, fmt::format("{}: the name of a page ends in .html", path));
}

void write_page(const std::string& path, const Mesh& mesh, const PageOptions& options) {
  check_page_extension(path);
  if (mesh.count_alive_faces() == 0)
    throw Error(ErrorKind::kUsage, fmt::format("{}: a mesh without faces cannot be shown", path));
  if (options.quality.size() != mesh.face_slots())
    throw Error(ErrorKind::kBug,
                fmt::format("{} quality values for {} faces", options.quality.size(), mesh.face_slots()));
  std::string histograms;
  for (const PageHistogram& histogram : options.histograms) histograms += histogram_drawing(histogram);
  write_file(path, filled(kPageTemplate, {{"title", escape_xml(options.title)},
                                          {"figures", figure_rows(options)},
                                          {"histograms", std::move(histograms)},
                                          {"mesh", mesh_json(mesh, options)},
                                          {"viewer", std::string(kPageViewer)}}));
}

}  // namespace quarry
