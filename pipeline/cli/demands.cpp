#include "pipeline/cli/demands.hpp"

#include <array>
#include <string_view>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "io/number_text.hpp"
#include "kernels/quality/face.hpp"

namespace quarry::cli {
namespace {

// A figure that is wanted to be at least (or at most) the limit, and the measure whose worst face tells where
// it fails.
struct Figure {
  std::string_view name;
  std::string_view meaning;
  bool at_least;
  double (*value)(const QualitySummary& quality);
  double (*of_face)(const Mesh& mesh, FaceId face);
};

double smallest_angle(const Mesh& mesh, FaceId face) {
  return measure_face(mesh, face, [](auto... corners) { return angle_range(corners...).smallest; });
}

double aspect(const Mesh& mesh, FaceId face) {
  return measure_face(mesh, face, [](auto... corners) { return edge_ratio(corners...); });
}

constexpr std::array kFigures = {
    Figure{"min-sj", "smallest scaled Jacobian, at least", true,
           [](const QualitySummary& q) { return q.all.scaled_jacobian.min; }, scaled_jacobian},
    Figure{"mean-sj", "mean scaled Jacobian, at least", true,
           [](const QualitySummary& q) { return q.all.scaled_jacobian.mean; }, nullptr},
    Figure{"below-0.2", "per cent of faces with a scaled Jacobian below 0.2, at most", false,
           [](const QualitySummary& q) { return 100 * q.all.share(q.all.scaled_jacobian_below_0p2); },
           nullptr},
    Figure{"min-angle", "smallest angle of a face in degrees, at least", true,
           [](const QualitySummary& q) { return q.all.min_angle.min; }, smallest_angle},
    Figure{"aspect", "longest by shortest edge of a face, at most", false,
           [](const QualitySummary& q) { return q.all.aspect.max; }, aspect},
    Figure{"irregular", "per cent of irregular interior vertices, at most", false,
           [](const QualitySummary& q) { return 100 * q.valence.irregular_share(); }, nullptr},
};

const Figure* find_figure(std::string_view name) {
  for (const Figure& figure : kFigures)
    if (figure.name == name) return &figure;
  return nullptr;
}

std::string known_names() {
  std::string names;
  for (const Figure& figure : kFigures) names += fmt::format("{}{}", names.empty() ? "" : ", ", figure.name);
  return names;
}

// " at (x, y)": the first corner of the worst face.
std::string place_of_worst(const Figure& figure, const Mesh& mesh) {
  if (figure.of_face == nullptr) return "";
  FaceId worst;
  double value = 0;
  for (const FaceId face : mesh.faces()) {
    if (!mesh.alive(face)) continue;
    const double own = figure.of_face(mesh, face);
    if (worst.valid() && !(figure.at_least ? own < value : own > value)) continue;
    worst = face;
    value = own;
  }
  if (!worst.valid()) return "";
  const Vec2 p = mesh.point(mesh.corner(worst, 0));
  return " at " + format_point(p.x, p.y);
}

}  // namespace

std::string demand_help() {
  std::string text;
  for (const Figure& figure : kFigures) text += fmt::format("  {:<31} {}\n", figure.name, figure.meaning);
  return text;
}

std::vector<Demand> parse_demands(const std::vector<std::string>& texts) {
  std::vector<Demand> demands;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    Demand demand{text.substr(0, equals), 0};
    if (find_figure(demand.name) == nullptr)
      throw Error(ErrorKind::kUsage,
                  fmt::format("--require {}: no such figure; there are {}", text, known_names()));
    const auto limit = equals == std::string::npos ? std::nullopt : parse_finite(text.substr(equals + 1));
    if (!limit)
      throw Error(ErrorKind::kUsage, fmt::format("--require {}: give it as {}=NUMBER", text, demand.name));
    demand.limit = *limit;
    demands.push_back(std::move(demand));
  }
  return demands;
}

void require_demands(const std::vector<Demand>& demands, const Mesh& mesh, const QualitySummary& quality) {
  for (const Demand& demand : demands) {
    const Figure& figure = *find_figure(demand.name);
    const double value = figure.value(quality);
    if (figure.at_least ? value >= demand.limit : value <= demand.limit) continue;
    throw Error(ErrorKind::kQuality,
                fmt::format("--require {}={}: it is {:.6g}{}; the mesh was not written", demand.name,
                            demand.limit, value, place_of_worst(figure, mesh)));
  }
}

}  // namespace quarry::cli
