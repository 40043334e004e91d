#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/mesh/group_name.hpp"
#include "io/mesh/grouped_entities.hpp"
#include "io/mesh/line_group_names.hpp"
#include "io/mesh/msh_format.hpp"
#include "io/mesh/text_output.hpp"

namespace quarry {
namespace {

constexpr int kMshLine = 1;
constexpr int kMshTriangle = 2;
constexpr int kMshQuad = 3;

class MshWriter {
 public:
  MshWriter(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options)
      : file_(path),
        mesh_(mesh),
        numbering_(mesh),
        grouped_(group_entities(mesh, numbering_)),
        line_groups_(mesh, options.line_groups) {
    for (const FaceGroup& group : grouped_.face_groups)
      if (regions_.empty() || regions_.back() != group.region) regions_.push_back(group.region);
    for (const EdgeGroup& group : grouped_.edge_groups)
      if (lines_.empty() || lines_.back() != group.constraint) lines_.push_back(group.constraint);
  }

  void write(const MeshWriteOptions& options) {
    file_.write("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n");
    if (!options.fields.empty()) {
      file_.write("$Comments\n");
      for (const FieldText& field : options.fields)
        file_.write(fmt::format("{}: {}\n", field.name, field.text));
      file_.write("$EndComments\n");
    }
    write_names(options.names);
    write_entities();
    write_nodes();
    write_elements();
    file_.commit();
  }

 private:
  // Physical tags: of curves, 1 is the outer boundary, a line has its index among lines_ + 2, and groups of
  // lines follow; of surfaces, the index among regions_ + 1. Entity tags are the index of the group + 1 for
  // curves, and as physical for surfaces.
  void write_names(const GroupNames& names) {
    file_.write(fmt::format("$PhysicalNames\n{}\n1 1 \"{}\"\n",
                            1 + lines_.size() + line_groups_.all().size() + regions_.size(),
                            kOuterBoundaryName));
    for (std::size_t i = 0; i < lines_.size(); ++i)
      file_.write(fmt::format("1 {} \"{}\"\n", i + 2, line_name(lines_[i], names)));
    for (std::size_t i = 0; i < line_groups_.all().size(); ++i)
      file_.write(fmt::format("1 {} \"{}\"\n", line_group_tag(i), line_groups_.all()[i]));
    for (std::size_t i = 0; i < regions_.size(); ++i)
      file_.write(fmt::format("2 {} \"{}\"\n", i + 1, region_name(regions_[i], names)));
    file_.write("$EndPhysicalNames\n");
  }

  [[nodiscard]] std::size_t line_tag(std::int32_t constraint) const {
    return static_cast<std::size_t>(std::lower_bound(lines_.begin(), lines_.end(), constraint) -
                                    lines_.begin()) +
           2;
  }
  [[nodiscard]] std::size_t line_group_tag(std::size_t index) const { return lines_.size() + 2 + index; }
  [[nodiscard]] std::size_t surface_tag(std::int32_t region) const {
    return static_cast<std::size_t>(std::lower_bound(regions_.begin(), regions_.end(), region) -
                                    regions_.begin()) +
           1;
  }

  // The box of the mesh for every entity: readers use it for drawing alone.
  [[nodiscard]] std::string bounds() const {
    Box2 box = mesh_.box();
    if (box.empty()) box = {{0, 0}, {0, 0}};
    double low = 0, high = 0;
    for (const double z : mesh_.zs()) {
      low = std::min(low, z);
      high = std::max(high, z);
    }
    return fmt::format("{} {} {} {} {} {}", box.low.x, box.low.y, low, box.high.x, box.high.y, high);
  }

  void write_entities() {
    const std::string box = bounds();
    file_.write(fmt::format("$Entities\n0 {} {} 0\n", grouped_.edge_groups.size(), regions_.size()));
    for (std::size_t i = 0; i < grouped_.edge_groups.size(); ++i) {
      const EdgeGroup& group = grouped_.edge_groups[i];
      const bool outer = group.kind == kOuterBoundary;
      const bool named = group.constraint >= 0 || !outer;
      std::vector<std::size_t> tags;
      if (outer) tags.push_back(1);
      if (named) tags.push_back(line_tag(group.constraint));
      // All edges of a line are in the same groups.
      for (const std::size_t index : line_groups_.of(grouped_.edges[group.begin]))
        tags.push_back(line_group_tag(index));
      file_.write(fmt::format("{} {} {} {} 0\n", i + 1, box, tags.size(), fmt::join(tags, " ")));
    }
    for (std::size_t i = 0; i < regions_.size(); ++i)
      file_.write(fmt::format("{} {} 1 {} 0\n", i + 1, box, i + 1));
    file_.write("$EndEntities\n");
  }

  void write_nodes() {
    const std::size_t count = numbering_.vertex_count();
    file_.write(fmt::format("$Nodes\n1 {0} 1 {0}\n2 1 0 {0}\n", count));
    write_lines(file_, count, [](TextLine line, std::size_t i) { line << i + 1 << "\n"; });
    write_lines(file_, count, [&](TextLine line, std::size_t i) {
      const Vec3 p = mesh_.point3(numbering_.vertex(i));
      line << p.x << " " << p.y << " " << p.z << "\n";
    });
    file_.write("$EndNodes\n");
  }

  void write_elements() {
    const std::size_t count = grouped_.edges.size() + grouped_.faces.size();
    file_.write(fmt::format("$Elements\n{} {} 1 {}\n",
                            grouped_.edge_groups.size() + grouped_.face_groups.size(), count, count));
    for (std::size_t g = 0; g < grouped_.edge_groups.size(); ++g) {
      const EdgeGroup& group = grouped_.edge_groups[g];
      file_.write(fmt::format("1 {} {} {}\n", g + 1, kMshLine, group.end - group.begin));
      write_lines(file_, group.end - group.begin, [&](TextLine line, std::size_t i) {
        const auto [a, b] = mesh_.edge_ends(grouped_.edges[group.begin + i]);
        line << group.begin + i + 1 << " " << numbering_.number(a) + 1 << " " << numbering_.number(b) + 1
             << "\n";
      });
    }
    for (const FaceGroup& group : grouped_.face_groups) write_faces(group);
    file_.write("$EndElements\n");
  }

  void write_faces(const FaceGroup& group) {
    file_.write(fmt::format("2 {} {} {}\n", surface_tag(group.region),
                            group.corners == 4 ? kMshQuad : kMshTriangle, group.end - group.begin));
    write_lines(file_, group.end - group.begin, [&](TextLine line, std::size_t i) {
      const FaceId f = grouped_.faces[group.begin + i];
      line << grouped_.edges.size() + group.begin + i + 1;
      for (int k = 0; k < group.corners; ++k) line << " " << numbering_.number(mesh_.corner(f, k)) + 1;
      line << "\n";
    });
  }

  AtomicFile file_;
  const Mesh& mesh_;
  LiveNumbering numbering_;
  GroupedEntities grouped_;
  LineGroupNames line_groups_;
  std::vector<std::int32_t> regions_;  // ascending
  std::vector<std::int32_t> lines_;    // ascending
};

}  // namespace

void write_msh(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options) {
  MshWriter(path, mesh, options).write(options);
}

}  // namespace quarry
