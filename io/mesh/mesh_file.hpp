// What every mesh format has in common: what is written beside the mesh, and how the data of a finished
// planar mesh are named.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "engine/mesh/mesh.hpp"

namespace quarry {

// A name and a text that describe the whole mesh: version, hash of the input, options.
struct FieldText {
  std::string name;
  std::string text;

  friend bool operator==(const FieldText&, const FieldText&) = default;
};

// Names of regions, lines and points that are not those of io/mesh/group_name.hpp: what other programs call
// them.
struct GroupNames {
  std::map<std::int32_t, std::string> regions, lines, points;
};

// Nodes at corners alone; in the middle of edges too (6 a triangle, 8 a quad); in the middle of quads as well
// (9).
enum class ElementOrder { kLinear, kQuadratic, kBiquadratic };

// Programs that want a format in a form of their own: OpenGeoSys (.vtu), MOOSE (.msh).
enum class MeshConsumer { kAny, kOpenGeoSys, kMoose };

// Groups of lines beside the lines themselves, or of regions beside these. The edge tag of this name (int32),
// the face tag of this name, or both, hold for each edge and face an index into the names, or -1.
struct Grouping {
  std::string tag;
  std::vector<std::string> names;
};

// The face tag (int32) with what regions are called, and the edge tag (int32) with the sides of a box: in
// formats whose groups have names these are called as their names alone are ("top", and not "box_side_top").
inline constexpr const char* kZoneTag = "zone";
inline constexpr const char* kBoxSideTag = "box_side";

struct MeshWriteOptions {
  // Where the format has a place for them.
  std::vector<FieldText> fields = {};
  GroupNames names = {};
  std::vector<Grouping> groups = {};
  // One value for each face slot; empty: not written. Formats without cell data leave them out.
  std::span<const double> scaled_jacobian = {};
  // zlib, where the format knows it. The bytes do not depend on the number of threads.
  bool compress = false;
  // Of a format that has such elements: see check_writable_order.
  ElementOrder order = ElementOrder::kLinear;
  MeshConsumer consumer = MeshConsumer::kAny;
};

// The edge tag with the apertures of lines (double; NaN where none is given), where a mesh has it.
inline constexpr const char* kApertureTag = "aperture";

// The vertex tag (int32) with the numbers of input points, -1 elsewhere, where a mesh has it.
inline constexpr const char* kPointTag = "point";

// Values of the edge tag "kind".
inline constexpr std::int32_t kInteriorConstraint = 1;
inline constexpr std::int32_t kOuterBoundary = 2;

// The edge tag (int32) of a mesh that is split along its interior constraints: of the two edges in the place
// of one, which have the same direction, kLeftSide for the one of the face on the left and kRightSide for the
// other; 0 for edges in one piece.
inline constexpr const char* kSideTag = "side";
inline constexpr std::int32_t kLeftSide = 1;
inline constexpr std::int32_t kRightSide = 2;

// The tags of a finished mesh; a mesh that lacks one reads as if it had the plainest value everywhere.
class MeshFileTags {
 public:
  explicit MeshFileTags(const Mesh& mesh)
      : mesh_(&mesh),
        region_(mesh.find_tag<FaceId, std::int32_t>("region")),
        constraint_(mesh.find_tag<EdgeId, std::int32_t>("constraint")),
        kind_(mesh.find_tag<EdgeId, std::int32_t>("kind")),
        side_(mesh.find_tag<EdgeId, std::int32_t>(kSideTag)) {}

  // Number of the enclosed region; 0 without the tag.
  [[nodiscard]] std::int32_t region(FaceId f) const { return region_.valid() ? region_[f] : 0; }
  // Number of the input line, or -1.
  [[nodiscard]] std::int32_t constraint(EdgeId e) const { return constraint_.valid() ? constraint_[e] : -1; }
  // kOuterBoundary for an edge with one face, else kInteriorConstraint.
  [[nodiscard]] std::int32_t kind(EdgeId e) const { return kind_.valid() ? kind_[e] : find_kind(e); }

  [[nodiscard]] bool split() const { return side_.valid(); }
  [[nodiscard]] std::int32_t side(EdgeId e) const { return side_.valid() ? side_[e] : 0; }

 private:
  [[nodiscard]] std::int32_t find_kind(EdgeId e) const {
    const auto [a, b] = mesh_->edge_ends(e);
    return mesh_->find_side(a, b).valid() && mesh_->find_side(b, a).valid() ? kInteriorConstraint
                                                                            : kOuterBoundary;
  }

  const Mesh* mesh_;
  Tag<FaceId, std::int32_t> region_;
  Tag<EdgeId, std::int32_t> constraint_;
  Tag<EdgeId, std::int32_t> kind_;
  Tag<EdgeId, std::int32_t> side_;
};

}  // namespace quarry
