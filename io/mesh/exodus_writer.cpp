#include <utility>
#include <vector>

#include <exodusII.h>
#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/atomic_file.hpp"
#include "io/mesh/cell_nodes.hpp"
#include "io/mesh/exodus_format.hpp"
#include "io/mesh/fracture_groups.hpp"
#include "io/mesh/given_names.hpp"
#include "io/mesh/group_name.hpp"

namespace quarry {
namespace {

struct ExodusBlock {
  std::string name;
  std::string type;
  int nodes = 0;
  std::vector<int> connectivity;
};

struct ExodusSideSet {
  std::string name;
  std::vector<int> elements, sides;
};

class ExodusWriter {
 public:
  ExodusWriter(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options)
      : file_(path),
        mesh_(mesh),
        numbering_(mesh),
        nodes_(mesh, numbering_, options.order),
        grouped_(group_entities(mesh, numbering_)),
        element_of_(mesh.face_slots()) {
    const GroupNames names = FileNames(options.names, NameForm::kQuoted).numbered();
    const FractureGroups groups = fracture_groups(mesh, numbering_, grouped_, names);
    for (std::size_t g = 0; g < grouped_.face_groups.size(); ++g) add_faces(g, names);
    for (const NamedEdges& block : groups.blocks) add_line(block);
    for (const NamedEdges& set : groups.side_sets) add_side_set(set);
  }

  // The library writes into the file's place before it is put where it belongs.
  void write() {
    ex_opts(0);  // it prints nothing by itself
    int computer_word = sizeof(double), file_word = sizeof(double);
    exodus_ = ex_create(file_.temporary().c_str(), EX_CLOBBER | EX_LARGE_MODEL, &computer_word, &file_word);
    check(exodus_);
    write_content();
    const int status = ex_close(std::exchange(exodus_, -1));
    check(status);
    file_.commit();
  }

  ~ExodusWriter() {
    if (exodus_ >= 0) ex_close(exodus_);
  }
  ExodusWriter(const ExodusWriter&) = delete;
  ExodusWriter& operator=(const ExodusWriter&) = delete;

 private:
  void check(int status) const {
    if (status < 0)
      throw Error(
          ErrorKind::kOutput,
          fmt::format(
              "{}: cannot be written by the Exodus library; is the disk full, or the mesh too large for "
              "the format?",
              file_.path()));
  }

  void add_faces(std::size_t g, const GroupNames& names) {
    const FaceGroup& group = grouped_.face_groups[g];
    ExodusBlock block;
    block.nodes = nodes_.face_count(grouped_.faces[group.begin]);
    block.type = fmt::format("{}{}", group.corners == 4 ? "QUAD" : "TRI", block.nodes);
    block.name = region_name(group.region, names);
    // Triangles come first.
    const bool quads_too =
        g + 1 < grouped_.face_groups.size() && grouped_.face_groups[g + 1].region == group.region;
    if (group.corners == 3 && quads_too) block.name += "_triangles";
    for (std::size_t i = group.begin; i < group.end; ++i) {
      const FaceId f = grouped_.faces[i];
      element_of_[f.value()] = static_cast<int>(++elements_);
      for (int k = 0; k < block.nodes; ++k)
        block.connectivity.push_back(static_cast<int>(nodes_.face_node(f, k) + 1));
    }
    blocks_.push_back(std::move(block));
  }

  void add_line(const NamedEdges& line) {
    ExodusBlock block{line.name, fmt::format("BAR{}", nodes_.edge_count()), nodes_.edge_count(), {}};
    elements_ += line.edges.size();
    for (const std::uint32_t edge : line.edges)
      for (int k = 0; k < block.nodes; ++k)
        block.connectivity.push_back(static_cast<int>(nodes_.edge_node(edge, k) + 1));
    blocks_.push_back(std::move(block));
  }

  void add_side_set(const NamedEdges& edges) {
    ExodusSideSet set{edges.name, {}, {}};
    for (const std::uint32_t edge : edges.edges) {
      const auto [a, b] = mesh_.edge_ends(numbering_.edges()[edge]);
      for (const SideId side : {mesh_.find_side(a, b), mesh_.find_side(b, a)}) {
        if (!side.valid()) continue;
        set.elements.push_back(element_of_[side.face().value()]);
        set.sides.push_back(side.index() + 1);
      }
    }
    if (!set.elements.empty()) side_sets_.push_back(std::move(set));
  }

  void write_content() {
    const std::int64_t dimension = mesh_.planar() ? 2 : 3;
    check(ex_put_init(exodus_, "quarry", dimension, static_cast<std::int64_t>(nodes_.count()),
                      static_cast<std::int64_t>(elements_), std::ssize(blocks_), 0, std::ssize(side_sets_)));
    write_points();
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      const ExodusBlock& block = blocks_[i];
      const auto id = static_cast<ex_entity_id>(i + 1);
      check(ex_put_block(exodus_, EX_ELEM_BLOCK, id, block.type.c_str(),
                         std::ssize(block.connectivity) / block.nodes, block.nodes, 0, 0, 0));
      check(ex_put_name(exodus_, EX_ELEM_BLOCK, id, block.name.c_str()));
      check(ex_put_conn(exodus_, EX_ELEM_BLOCK, id, block.connectivity.data(), nullptr, nullptr));
    }
    for (std::size_t i = 0; i < side_sets_.size(); ++i) {
      const ExodusSideSet& set = side_sets_[i];
      const auto id = static_cast<ex_entity_id>(i + 1);
      check(ex_put_set_param(exodus_, EX_SIDE_SET, id, std::ssize(set.elements), 0));
      check(ex_put_name(exodus_, EX_SIDE_SET, id, set.name.c_str()));
      check(ex_put_set(exodus_, EX_SIDE_SET, id, set.elements.data(), set.sides.data()));
    }
  }

  void write_points() {
    std::vector<double> x, y, z;
    for (std::size_t i = 0; i < nodes_.count(); ++i) {
      const Vec3 p = nodes_.point(i);
      x.push_back(p.x);
      y.push_back(p.y);
      z.push_back(p.z);
    }
    if (x.empty()) return;
    check(ex_put_coord(exodus_, x.data(), y.data(), mesh_.planar() ? nullptr : z.data()));
  }

  AtomicFile file_;
  const Mesh& mesh_;
  LiveNumbering numbering_;
  CellNodes nodes_;
  GroupedEntities grouped_;
  std::vector<int> element_of_;  // by face slot, from 1
  std::size_t elements_ = 0;
  std::vector<ExodusBlock> blocks_;
  std::vector<ExodusSideSet> side_sets_;
  int exodus_ = -1;
};

}  // namespace

void write_exodus(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options) {
  ExodusWriter(path, mesh, options).write();
}

}  // namespace quarry
