#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/mesh/cell_nodes.hpp"
#include "io/mesh/extra_groups.hpp"
#include "io/mesh/given_names.hpp"
#include "io/mesh/group_name.hpp"
#include "io/mesh/grouped_entities.hpp"
#include "io/mesh/marked_points.hpp"
#include "io/mesh/msh_curves.hpp"
#include "io/mesh/msh_format.hpp"
#include "io/text_output.hpp"

namespace quarry {
namespace {

// Element types by the number of nodes.
int msh_face_type(int nodes) {
  switch (nodes) {
    case 3:
      return 2;
    case 4:
      return 3;
    case 6:
      return 9;
    case 8:
      return 16;
    default:
      return 10;
  }
}

int msh_line_type(int nodes) { return nodes == 2 ? 1 : 8; }

class MshWriter {
 public:
  MshWriter(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options)
      : file_(path),
        mesh_(mesh),
        numbering_(mesh),
        nodes_(mesh, numbering_, options.order),
        grouped_(group_entities(mesh, numbering_)),
        names_(options.names, NameForm::kQuoted),
        lines_(options.consumer == MeshConsumer::kMoose
                   ? curves_for_moose(fracture_groups(mesh, numbering_, grouped_, names_.numbered()))
                   : curves_by_line(grouped_, names_.numbered(),
                                    ExtraGroups<EdgeId>(mesh, options.groups, names_.of_lines()))) {
    // MOOSE would take them for blocks of the lowest dimension.
    if (options.consumer != MeshConsumer::kMoose) points_ = marked_points(mesh, numbering_);
    const ExtraGroups<FaceId> extra(mesh, options.groups, names_.of_regions());
    for (const FaceGroup& group : grouped_.face_groups) {
      if (!regions_.empty() && regions_.back() == group.region) continue;
      regions_.push_back(group.region);
      extra_of_region_.push_back(extra.of(grouped_.faces[group.begin]));
    }
    if (options.consumer != MeshConsumer::kMoose) extra_names_ = extra.all();
  }

  void write(const MeshWriteOptions& options) {
    file_.write("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n");
    if (!options.fields.empty()) {
      file_.write("$Comments\n");
      for (const FieldText& field : options.fields)
        file_.write(fmt::format("{}: {}\n", field.name, field.text));
      file_.write("$EndComments\n");
    }
    write_names();
    write_entities();
    write_nodes();
    write_elements();
    file_.commit();
  }

 private:
  // Entity tags count from 1, of curves and of surfaces; the physical tag of a surface follows from it.
  void write_names() {
    const GroupNames& names = names_.numbered();
    file_.write(fmt::format("$PhysicalNames\n{}\n",
                            points_.size() + lines_.names.size() + regions_.size() + extra_names_.size()));
    for (std::size_t i = 0; i < points_.size(); ++i)
      file_.write(fmt::format("0 {} \"{}\"\n", i + 1, point_name(points_[i].point, names)));
    for (std::size_t i = 0; i < lines_.names.size(); ++i)
      file_.write(fmt::format("1 {} \"{}\"\n", i + 1, lines_.names[i]));
    for (std::size_t i = 0; i < regions_.size(); ++i)
      file_.write(
          fmt::format("2 {} \"{}\"\n", lines_.surface_offset + i + 1, region_name(regions_[i], names)));
    for (std::size_t i = 0; i < extra_names_.size(); ++i)
      file_.write(fmt::format("2 {} \"{}\"\n", extra_tag(i), extra_names_[i]));
    file_.write("$EndPhysicalNames\n");
  }

  // Of the physical surface of an extra group.
  [[nodiscard]] std::size_t extra_tag(std::size_t group) const {
    return lines_.surface_offset + regions_.size() + group + 1;
  }

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
    file_.write(
        fmt::format("$Entities\n{} {} {} 0\n", points_.size(), lines_.curves.size(), regions_.size()));
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Vec3 p = nodes_.point(points_[i].vertex);
      file_.write(fmt::format("{} {} {} {} 1 {}\n", i + 1, p.x, p.y, p.z, i + 1));
    }
    for (std::size_t i = 0; i < lines_.curves.size(); ++i) {
      const std::vector<std::size_t>& groups = lines_.curves[i].groups;
      file_.write(fmt::format("{} {} {}{}{} 0\n", i + 1, box, groups.size(), groups.empty() ? "" : " ",
                              fmt::join(groups, " ")));
    }
    for (std::size_t i = 0; i < regions_.size(); ++i) {
      std::vector<std::size_t> groups = {lines_.surface_offset + i + 1};
      if (!extra_names_.empty())
        for (const std::size_t group : extra_of_region_[i]) groups.push_back(extra_tag(group));
      file_.write(fmt::format("{} {} {} {} 0\n", i + 1, box, groups.size(), fmt::join(groups, " ")));
    }
    file_.write("$EndEntities\n");
  }

  void write_nodes() {
    const std::size_t count = nodes_.count();
    file_.write(fmt::format("$Nodes\n1 {0} 1 {0}\n2 1 0 {0}\n", count));
    write_lines(file_, count, [](TextLine line, std::size_t i) { line << i + 1 << "\n"; });
    write_lines(file_, count, [&](TextLine line, std::size_t i) {
      const Vec3 p = nodes_.point(i);
      line << p.x << " " << p.y << " " << p.z << "\n";
    });
    file_.write("$EndNodes\n");
  }

  void write_elements() {
    const std::size_t before = points_.size() + lines_.edge_count(), count = before + grouped_.faces.size();
    file_.write(fmt::format("$Elements\n{} {} 1 {}\n",
                            points_.size() + lines_.curves.size() + grouped_.face_groups.size(), count,
                            count));
    for (std::size_t i = 0; i < points_.size(); ++i)
      file_.write(fmt::format("0 {} 15 1\n{} {}\n", i + 1, i + 1, points_[i].vertex + 1));
    std::size_t first = points_.size() + 1;
    for (std::size_t g = 0; g < lines_.curves.size(); ++g) {
      const std::vector<std::uint32_t>& edges = lines_.curves[g].edges;
      file_.write(fmt::format("1 {} {} {}\n", g + 1, msh_line_type(nodes_.edge_count()), edges.size()));
      write_lines(file_, edges.size(), [&](TextLine line, std::size_t i) {
        line << first + i;
        for (int k = 0; k < nodes_.edge_count(); ++k) line << " " << nodes_.edge_node(edges[i], k) + 1;
        line << "\n";
      });
      first += edges.size();
    }
    for (const FaceGroup& group : grouped_.face_groups) write_faces(group, before);
    file_.write("$EndElements\n");
  }

  // before: elements before the faces.
  void write_faces(const FaceGroup& group, std::size_t before) {
    const int nodes = nodes_.face_count(grouped_.faces[group.begin]);
    file_.write(fmt::format("2 {} {} {}\n", surface_tag(group.region), msh_face_type(nodes),
                            group.end - group.begin));
    write_lines(file_, group.end - group.begin, [&](TextLine line, std::size_t i) {
      const FaceId f = grouped_.faces[group.begin + i];
      line << before + group.begin + i + 1;
      for (int k = 0; k < nodes; ++k) line << " " << nodes_.face_node(f, k) + 1;
      line << "\n";
    });
  }

  AtomicFile file_;
  const Mesh& mesh_;
  LiveNumbering numbering_;
  CellNodes nodes_;
  GroupedEntities grouped_;
  FileNames names_;
  MshCurves lines_;
  std::vector<MarkedPoint> points_;
  std::vector<std::int32_t> regions_;  // ascending
  std::vector<std::vector<std::size_t>> extra_of_region_;
  std::vector<std::string> extra_names_;  // of surfaces; none for MOOSE, where no face may be in two groups
};

}  // namespace

void write_msh(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options) {
  MshWriter(path, mesh, options).write(options);
}

}  // namespace quarry
