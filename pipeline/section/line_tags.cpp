#include "pipeline/section/line_tags.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "io/input_text.hpp"

namespace quarry {
namespace {

// index(line): of its name, or -1.
template <class Index>
void add_grouping(Mesh& mesh, Grouping grouping, std::vector<Grouping>& all, Index&& index) {
  const auto constraint = mesh.find_tag<EdgeId, std::int32_t>("constraint");
  auto tag = mesh.add_tag<EdgeId, std::int32_t>(grouping.tag, -1);
  for (const EdgeId e : IdRange<EdgeId>(mesh.edge_slots()))
    if (constraint[e] >= 0) tag[e] = index(LineId(static_cast<std::uint32_t>(constraint[e])));
  all.push_back(std::move(grouping));
}

void group_by(Mesh& mesh, const LineSet& lines, const std::string& name, std::string LineAttributes::*member,
              std::vector<Grouping>& all) {
  Grouping grouping{name, {}};
  std::map<std::string, std::int32_t> known;
  // Of each set of attributes that a line has; those of points are no groups of lines.
  std::vector<std::int32_t> index(lines.attributes.size(), -1);
  for (const InputLine& line : lines.lines) {
    if (line.attributes >= index.size() || index[line.attributes] >= 0) continue;
    const std::string& text = lines.attributes[line.attributes].*member;
    if (text.empty()) continue;
    const auto [at, fresh] = known.emplace(text, static_cast<std::int32_t>(grouping.names.size()));
    if (fresh) grouping.names.push_back(text);
    index[line.attributes] = at->second;
  }
  if (grouping.names.empty()) return;
  add_grouping(mesh, std::move(grouping), all, [&](LineId line) {
    const std::uint32_t attributes = lines.lines[line].attributes;
    return attributes < index.size() ? index[attributes] : -1;
  });
}

void tag_apertures(Mesh& mesh, const LineSet& lines) {
  const auto given = [](const LineAttributes& attributes) { return attributes.aperture.has_value(); };
  if (std::ranges::none_of(lines.attributes, given)) return;
  const auto constraint = mesh.find_tag<EdgeId, std::int32_t>("constraint");
  auto tag = mesh.add_tag<EdgeId, double>(kApertureTag, std::numeric_limits<double>::quiet_NaN());
  for (const EdgeId e : IdRange<EdgeId>(mesh.edge_slots())) {
    if (constraint[e] < 0) continue;
    const std::uint32_t attributes =
        lines.lines[LineId(static_cast<std::uint32_t>(constraint[e]))].attributes;
    if (attributes < lines.attributes.size() && given(lines.attributes[attributes]))
      tag[e] = *lines.attributes[attributes].aperture;
  }
}

}  // namespace

void tag_box_sides(Mesh& mesh, std::vector<Grouping>& groups) {
  const Box2 box = mesh.box();
  const auto kind = mesh.find_tag<EdgeId, std::int32_t>("kind");
  auto tag = mesh.add_tag<EdgeId, std::int32_t>(kBoxSideTag, -1);
  for (const EdgeId e : IdRange<EdgeId>(mesh.edge_slots())) {
    if (kind[e] != kOuterBoundary) continue;
    const auto [a, b] = mesh.edge_ends(e);
    const Vec2 p = mesh.point(a), q = mesh.point(b);
    if (p.x == q.x) {
      tag[e] = p.x == box.low.x ? 0 : p.x == box.high.x ? 1 : -1;
    } else if (p.y == q.y) {
      tag[e] = p.y == box.low.y ? 2 : p.y == box.high.y ? 3 : -1;
    }
  }
  groups.push_back({kBoxSideTag, {"left", "right", "bottom", "top"}});
}

std::vector<std::string> file_group_names(const std::vector<std::string>& paths) {
  std::vector<std::string> names;
  for (const std::string& path : paths) {
    const std::string stem = path == kStandardInput ? "stdin" : std::filesystem::path(path).stem().string();
    std::string name = stem;
    for (int i = 2; std::ranges::find(names, name) != names.end(); ++i) name = fmt::format("{}_{}", stem, i);
    names.push_back(std::move(name));
  }
  return names;
}

std::vector<Grouping> tag_lines(Mesh& mesh, const LineSet& lines, const std::vector<std::string>& paths) {
  std::vector<Grouping> groups;
  group_by(mesh, lines, "name", &LineAttributes::name, groups);
  group_by(mesh, lines, "set", &LineAttributes::set, groups);
  group_by(mesh, lines, "material", &LineAttributes::material, groups);
  if (paths.size() > 1)
    add_grouping(mesh, {"file", file_group_names(paths)}, groups,
                 [&](LineId line) { return static_cast<std::int32_t>(lines.lines[line].file); });
  tag_apertures(mesh, lines);
  return groups;
}

}  // namespace quarry
