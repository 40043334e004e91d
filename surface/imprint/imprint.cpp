#include "surface/imprint/imprint.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "surface/imprint/split_surface.hpp"
#include "surface/project/triangle_tree.hpp"

namespace quarry {
namespace {

// A way across the surface may turn from the straight one to its aim by less than 75 degrees.
constexpr double kLeastForward = 0.26;
// Halvings that find the last place of a line on the surface.
constexpr int kHalvings = 20;

class Imprinter {
 public:
  Imprinter(RepairedSurface& repaired, const ImprintOptions& options, ImprintReport& report)
      : tree_(repaired.surface.points, repaired.surface.triangles),
        split_(repaired),
        options_(options),
        report_(report) {
    for (const Vec3 p : repaired.surface.points) top_ = std::max(top_, p.z);
    top_ += 1 + std::abs(top_);
  }

  void add(const SurfaceLine& line, std::int32_t number) {
    line_ = &line;
    number_ = number;
    course_ = &courses_.emplace_back();
    told_ = &report_.lines.emplace_back();
    last_.reset();
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      if (i > 0) lead(line.points[i - 1], line.points[i]);
      visit(line.points[i], true);
    }
    if (told_->edges + told_->shared > 0) ++report_.imprinted;
  }

  std::vector<LineEdge> finish() {
    split_.finish();
    find_meetings();
    std::vector<LineEdge> edges;
    for (const auto& [ends, number] : split_.marks()) edges.push_back({ends, number});
    return edges;
  }

 private:
  struct Foot {
    std::uint32_t triangle;
    Vec3 place;
  };

  [[nodiscard]] std::optional<Foot> foot_of(Vec3 p) const {
    if (line_->has_heights) {
      ClosestQuery query;
      query.radius = options_.reach;
      const SurfacePoint found = tree_.closest(p, query);
      if (!found.triangle.valid()) return std::nullopt;
      return Foot{found.triangle.value(), found.position};
    }
    const SurfaceHit hit = tree_.ray({p.x, p.y, top_}, {0, 0, -1});
    if (!hit.triangle.valid()) return std::nullopt;
    return Foot{hit.triangle.value(), hit.position};
  }

  // Steps from a to b, without either.
  void lead(Vec3 a, Vec3 b) {
    Vec3 d = b - a;
    if (!line_->has_heights) d.z = 0;
    const double steps = std::ceil(length(d) / options_.step);
    Vec3 before = a;
    for (double i = 1; i <= steps; ++i) {
      const Vec3 p = i < steps ? a + (i / steps) * (b - a) : b;
      if (foot_of(before).has_value() != foot_of(p).has_value()) visit_rim(before, p);
      if (i < steps) visit(p, false);
      before = p;
    }
  }

  // Where the line leaves the surface, or comes to it.
  void visit_rim(Vec3 a, Vec3 b) {
    const bool leaves = foot_of(a).has_value();
    Vec3 on = leaves ? a : b, off = leaves ? b : a;
    for (int i = 0; i < kHalvings; ++i) {
      const Vec3 middle = 0.5 * (on + off);
      (foot_of(middle) ? on : off) = middle;
    }
    report_.outside.add(on);
    ++told_->outside;
    visit(on, true);
  }

  // The next place of the line. One that need not be a point of it, and lies near the last one, is passed
  // over.
  void visit(Vec3 p, bool must) {
    const std::optional<Foot> foot = foot_of(p);
    if (!foot) {
      last_.reset();
      return;
    }
    if (!must && last_ && length(split_.point(*last_) - foot->place) < 0.5 * options_.step) return;
    const std::uint32_t next = split_.point_at(foot->triangle, foot->place, options_.snap);
    if (must) told_->places.push_back(foot->place);
    if (last_ && *last_ != next && !go(*last_, next)) {
      report_.lost.add(foot->place);
      ++told_->lost;
    }
    last_ = next;
    course_->push_back(next);
  }

  // From point to point, through edges that are there or that cutting makes; each step comes nearer to the
  // aim.
  bool go(std::uint32_t from, std::uint32_t aim) {
    while (from != aim) {
      const std::optional<std::uint32_t> next = step(from, aim);
      if (!next) return false;
      const std::int32_t owner = split_.mark(from, *next, number_);
      ++(owner == number_ ? told_->edges : told_->shared);
      if (owner != number_) report_.lines[static_cast<std::size_t>(owner)].lends = true;
      from = *next;
      course_->push_back(from);
    }
    return true;
  }

  // Of each line, the others that have points of it.
  void find_meetings() {
    std::vector<std::pair<std::uint32_t, std::int32_t>> at;  // points and lines
    for (const auto& [ends, number] : split_.marks())
      for (const std::uint32_t p : ends) at.emplace_back(p, number);
    for (std::size_t i = 0; i < courses_.size(); ++i)
      for (const std::uint32_t p : courses_[i]) at.emplace_back(p, static_cast<std::int32_t>(i));
    sort_unique(at);
    for (std::size_t begin = 0, end = 0; begin < at.size(); begin = end) {
      while (end < at.size() && at[end].first == at[begin].first) ++end;
      if (end - begin > 1) meet(std::span(at).subspan(begin, end - begin));
    }
    for (ImprintedLine& told : report_.lines) sort_unique(told.with);
  }

  // At one point.
  void meet(std::span<const std::pair<std::uint32_t, std::int32_t>> lines) {
    for (const auto& [p, line] : lines) {
      const std::vector<std::uint32_t>& course = courses_[static_cast<std::size_t>(line)];
      ImprintedLine& told = report_.lines[static_cast<std::size_t>(line)];
      told.meets = told.meets || (p != course.front() && p != course.back());
      for (const auto& [same, other] : lines)
        if (other != line) told.with.push_back(other);
    }
  }
  template <class T>
  static void sort_unique(std::vector<T>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
  }

  struct Way {
    double forward = kLeastForward;  // the cosine of the turn from the straight way
    std::uint32_t x = 0, y = 0;      // to x if they are equal; else between them
    double share = 0;                // from x to y
  };

  std::optional<std::uint32_t> step(std::uint32_t from, std::uint32_t aim) {
    if (split_.has_edge(from, aim)) return aim;
    const Vec3 here = split_.point(from);
    const Vec3 d = split_.point(aim) - here;
    Way best;
    for (const std::uint32_t t : split_.around(from)) consider(t, from, d, best);
    if (!(best.forward > kLeastForward)) return std::nullopt;
    const auto nearer = [&](Vec3 p) { return length(split_.point(aim) - p) < length(d); };
    if (best.x == best.y) return nearer(split_.point(best.x)) ? std::optional(best.x) : std::nullopt;
    const Vec3 x = split_.point(best.x), y = split_.point(best.y);
    const double width = length(y - x);
    if (best.share * width <= options_.snap && nearer(x)) return best.x;
    if ((1 - best.share) * width <= options_.snap && nearer(y)) return best.y;
    const Vec3 place = x + best.share * (y - x);
    if (!nearer(place)) return std::nullopt;
    return split_.split_edge(best.x, best.y, place);
  }

  // The way across one triangle, or along its edges, if it is straighter than the best one so far.
  void consider(std::uint32_t triangle, std::uint32_t from, Vec3 d, Way& best) const {
    const SurfaceTriangle& corners = split_.surface().triangles[triangle];
    const auto k =
        static_cast<std::size_t>(std::find(corners.begin(), corners.end(), from) - corners.begin());
    const std::uint32_t x = corners[(k + 1) % 3], y = corners[(k + 2) % 3];
    const Vec3 u = split_.point(x) - split_.point(from), w = split_.point(y) - split_.point(from);
    const auto offer = [&](Vec3 way, std::uint32_t a, std::uint32_t b, double share) {
      const double forward = dot(way, d) / (length(way) * length(d));
      if (forward > best.forward) best = {forward, a, b, share};
    };
    offer(u, x, x, 0);
    offer(w, y, y, 0);
    const Vec3 n = cross(u, w);
    const double squared = dot(n, n);
    if (!(squared > 0)) return;
    const Vec3 flat = d - (dot(d, n) / squared) * n;
    const double right = dot(cross(u, flat), n), left = dot(cross(flat, w), n);
    if (right > 0 && left > 0) offer(flat, x, y, right / (right + left));
  }

  TriangleTree tree_;  // of the surface as it was at first
  SplitSurface split_;
  const ImprintOptions& options_;
  ImprintReport& report_;
  double top_ = 0;
  const SurfaceLine* line_ = nullptr;
  std::int32_t number_ = 0;
  ImprintedLine* told_ = nullptr;
  std::vector<std::uint32_t>* course_ = nullptr;
  std::vector<std::vector<std::uint32_t>>
      courses_;                        // by line: the points of the surface that it goes through
  std::optional<std::uint32_t> last_;  // the point of the surface that the line has come to
};

}  // namespace

std::vector<LineEdge> imprint_lines(RepairedSurface& repaired, std::span<const SurfaceLine> lines,
                                    const ImprintOptions& options, ImprintReport& report) {
  Imprinter imprinter(repaired, options, report);
  for (std::size_t i = 0; i < lines.size(); ++i) imprinter.add(lines[i], static_cast<std::int32_t>(i));
  return imprinter.finish();
}

}  // namespace quarry
