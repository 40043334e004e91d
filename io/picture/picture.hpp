// A picture of a mesh from which one can see whether it is good: faces by region or by quality, their edges
// as far as they can be told apart, constraints and the outline on top, a scale bar. Meshes in space are
// shaded, and what is hidden is left out.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "engine/base/progress.hpp"
#include "engine/geometry/box.hpp"
#include "engine/mesh/mesh.hpp"

namespace quarry {

enum class PictureColours {
  kRegion,      // a pastel colour for each number of the face tag "region"
  kQuality,     // a measure of each face, from red (bad) to blue (good)
  kConstraint,  // plain faces, a strong colour for each number of the edge tag "constraint"
};

enum class UpAxis { kY, kZ };

// Where the eye stands, in degrees: around the axis that points up, from the first axis that follows it, and
// above the plane across.
struct ViewDirection {
  double azimuth = 35, elevation = 25;
  UpAxis up = UpAxis::kZ;
};

struct Ball {
  Vec3 center;
  double radius = 0;
};

struct PictureOptions {
  PictureColours colours = PictureColours::kRegion;
  // For kQuality: a value in [0, 1] for each face slot; what is not positive is drawn in black.
  std::span<const double> quality = {};
  std::string quality_name = "scaled Jacobian";
  // Pixels (.png) or user units (.svg); lines and letters grow with it.
  int width = 1600;
  // Of a planar mesh shows this part only, in the units of the coordinates.
  std::optional<Box2> window = {};
  // Of a mesh in space: from where, and only the faces that lie in a ball.
  ViewDirection view = {};
  std::optional<Ball> around = {};
};

// Writes .svg or .png as the extension says. Throws Error(kUsage) for another extension, a width outside
// [64, 20000], a window or ball that is empty or holds no face, a mesh without faces, a window of a mesh in
// space or a ball of one in the plane; Error(kOutput) where it cannot be written; Error(kInterrupted), before
// it writes, once the progress is cancelled.
void write_picture(const std::string& path, const Mesh& mesh, const PictureOptions& options,
                   const Progress& progress = Progress());

// Throws Error(kUsage) unless write_picture knows the extension: for a check before a long job.
void check_picture_extension(const std::string& path);

}  // namespace quarry
