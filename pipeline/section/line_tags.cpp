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
void add_grouping(Mesh& mesh, LineGrouping grouping, std::vector<LineGrouping>& all, Index&& index) {
  const auto constraint = mesh.find_tag<EdgeId, std::int32_t>("constraint");
  auto tag = mesh.add_tag<EdgeId, std::int32_t>(grouping.tag, -1);
  for (const EdgeId e : IdRange<EdgeId>(mesh.edge_slots()))
    if (constraint[e] >= 0) tag[e] = index(LineId(static_cast<std::uint32_t>(constraint[e])));
  all.push_back(std::move(grouping));
}

void group_by(Mesh& mesh, const LineSet& lines, const std::string& name, std::string LineAttributes::*member,
              std::vector<LineGrouping>& all) {
  LineGrouping grouping{name, {}};
  std::map<std::string, std::int32_t> known;
  // Of each set of attributes.
  std::vector<std::int32_t> index;
  for (const LineAttributes& attributes : lines.attributes) {
    const std::string& text = attributes.*member;
    if (text.empty()) {
      index.push_back(-1);
      continue;
    }
    const auto [at, fresh] = known.emplace(text, static_cast<std::int32_t>(grouping.names.size()));
    if (fresh) grouping.names.push_back(text);
    index.push_back(at->second);
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

std::vector<LineGrouping> tag_lines(Mesh& mesh, const LineSet& lines, const std::vector<std::string>& paths) {
  std::vector<LineGrouping> groups;
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
