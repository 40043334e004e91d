#include "kernels/smooth/square_step.hpp"

#include <algorithm>
#include <cmath>

namespace quarry {
namespace {

// The conjugate gradients end after so many iterations, or where the residual (by the preconditioner) has
// fallen by this factor: beyond that the next step, on the moved mesh, does better.
constexpr int kIterations = 20;
constexpr double kReduction = 0.02;
// The share by which the diagonal is raised (Levenberg): how much less is done where the system is soft.
constexpr float kDamping = 0.003F;

// What a face adds to the system, in units of `unit`: the derivatives of its residuals by the places of its
// corners, and from them the products. The residuals are those of its corners, and of its area.
template <int kCorners>
class FaceTerms {
 public:
  static constexpr int kLanes = 2 * kCorners;
  float matrix[kLanes][kLanes] = {};
  float gradient[kLanes] = {};

  FaceTerms(const Vec2 (&places)[kCorners], double unit) : places_(places), per_unit_(1 / unit) {
    for (int k = 0; k < kCorners; ++k) {
      const Vec2 edge = per_unit_ * (places[next(k)] - places[k]);
      x_[k] = static_cast<float>(edge.x);
      y_[k] = static_cast<float>(edge.y);
    }
    for (int k = 0; k < kCorners; ++k) squared_[k] = x_[k] * x_[k] + y_[k] * y_[k];
  }

  void add_corners() {
    float lengths[kCorners], inverse[kCorners];
    for (int k = 0; k < kCorners; ++k) lengths[k] = std::sqrt(squared_[k]);
    for (int k = 0; k < kCorners; ++k) inverse[k] = 1 / squared_[k];
    for (int k = 0; k < kCorners; ++k) {
      const int before = previous(k);
      // Of this edge, and the one before reversed.
      const float dot = -(x_[k] * x_[before] + y_[k] * y_[before]);
      const float cross = -(x_[k] * y_[before] - y_[k] * x_[before]);
      const auto [value, slope] =
          angle_residual(dot, cross, lengths[k] * lengths[before], wanted_angle<float>(kQuad));
      residuals_[k] = value;
      // The angle grows as the next corner turns right around this one, and as the one before turns left.
      const float out = slope * inverse[k];
      const float back = slope * inverse[before];
      const float next_x = out * y_[k], next_y = -out * x_[k];
      const float before_x = back * y_[before], before_y = -back * x_[before];
      set(k, next(k), next_x, next_y);
      set(k, before, before_x, before_y);
      set(k, k, -next_x - before_x, -next_y - before_y);
    }
  }

  void add_area(AreaDemand demand) {
    const Vec2 first = per_unit_ * (places_[kQuad ? 2 : 1] - places_[0]);
    const Vec2 second = per_unit_ * (places_[kQuad ? 3 : 2] - places_[kQuad ? 1 : 0]);
    const double share = kQuad ? 0.5 : 1.0;
    const Residual residual =
        area_residual(share * cross(first, second), {demand.wanted * per_unit_ * per_unit_, demand.weight});
    residuals_[kCorners] = static_cast<float>(residual.value);
    const auto slope = static_cast<float>(share * residual.slope);
    for (int k = 0; k < kCorners; ++k) {
      // The area grows as a corner moves to the left of the line between its neighbours, from the next on.
      const Vec2 across = per_unit_ * (places_[previous(k)] - places_[next(k)]);
      set(kCorners, k, -slope * static_cast<float>(across.y), slope * static_cast<float>(across.x));
    }
  }

  void multiply() {
    for (int r = 0; r <= kCorners; ++r)
      for (int i = 0; i < kLanes; ++i) {
        gradient[i] += jacobian_[r][i] * residuals_[r];
        for (int j = 0; j < kLanes; ++j) matrix[i][j] += jacobian_[r][i] * jacobian_[r][j];
      }
  }

  // The weighted squared length of each edge, halved, since faces share edges; by the shortest of them.
  void add_springs(float spring) {
    const float weight = 0.125F * spring * spring / *std::min_element(squared_, squared_ + kCorners);
    for (int k = 0; k < kCorners; ++k) {
      const int a = 2 * k;
      const int b = 2 * next(k);
      for (int d = 0; d < 2; ++d) {
        matrix[a + d][a + d] += weight;
        matrix[b + d][b + d] += weight;
        matrix[a + d][b + d] -= weight;
        matrix[b + d][a + d] -= weight;
        const float pull = weight * (d == 0 ? x_[k] : y_[k]);
        gradient[a + d] -= pull;
        gradient[b + d] += pull;
      }
    }
  }

 private:
  static constexpr bool kQuad = kCorners == 4;
  static constexpr int next(int k) { return k + 1 < kCorners ? k + 1 : 0; }
  static constexpr int previous(int k) { return k > 0 ? k - 1 : kCorners - 1; }

  void set(int row, int corner, float x, float y) {
    jacobian_[row][2 * corner] = x;
    jacobian_[row][2 * corner + 1] = y;
  }

  const Vec2 (&places_)[kCorners];
  double per_unit_;
  float x_[kCorners], y_[kCorners], squared_[kCorners];  // edges, from each corner to the next
  float jacobian_[kCorners + 1][kLanes] = {};
  float residuals_[kCorners + 1] = {};
};

}  // namespace

void SquareStep::choose_unknowns(VertexId begin, VertexId end, const std::vector<std::uint8_t>& active) {
  begin_ = begin;
  numbers_.assign(end.value() - begin.value(), kFrozen);
  unknowns_.clear();
  double squares = 0;
  for (VertexId v = begin; v < end; v = VertexId(v.value() + 1)) {
    if (active[v.value()] == 0 || !slide_->movable(v)) continue;
    numbers_[v.value() - begin.value()] = static_cast<std::uint32_t>(unknowns_.size());
    const Vec2 along = slide_->direction(v);
    unknowns_.push_back(
        {v, {static_cast<float>(along.x), static_cast<float>(along.y)}, {0, 0, 0}, {}, {}, {}});
    squares += squared_length(mesh_->point(mesh_->target(mesh_->side_of(v))) - mesh_->point(v));
  }
  if (!unknowns_.empty()) unit_ = std::sqrt(squares / static_cast<double>(unknowns_.size()));
}

void SquareStep::lay_out_rows() {
  row_starts_.clear();
  columns_.clear();
  const auto add = [this](VertexId v) {
    const std::uint32_t column = unknown_of(v);
    if (column != kFrozen) columns_.push_back(column);
  };
  for (std::uint32_t row = 0; row < unknowns_.size(); ++row) {
    row_starts_.push_back(static_cast<std::uint32_t>(columns_.size()));
    columns_.push_back(row);
    for_each_side_around(*mesh_, unknowns_[row].vertex, [&](SideId s) {
      const SideId forward = mesh_->next(s);
      add(mesh_->origin(forward));
      if (mesh_->corner_count(s.face()) == 4) add(mesh_->target(forward));
      const SideId in = mesh_->previous(s);
      if (!mesh_->neighbour(in).valid()) add(mesh_->origin(in));
    });
  }
  row_starts_.push_back(static_cast<std::uint32_t>(columns_.size()));
  blocks_.assign(columns_.size(), Block{});
}

SquareStep::Block& SquareStep::block(std::uint32_t row, std::uint32_t column) {
  std::uint32_t k = row_starts_[row];
  while (columns_[k] != column) ++k;
  return blocks_[k];
}

template <int kCorners>
void SquareStep::add_face(FaceId f) {
  std::uint32_t numbers[kCorners];
  Vec2 places[kCorners];
  for (int k = 0; k < kCorners; ++k) {
    const VertexId v = mesh_->corner(f, k);
    numbers[k] = unknown_of(v);
    places[k] = mesh_->point(v);
  }
  FaceTerms<kCorners> terms(places, unit_);
  terms.add_corners();
  if (!demands_->empty()) terms.add_area((*demands_)[f]);
  terms.multiply();
  terms.add_springs(spring_);
  for (int i = 0; i < kCorners; ++i) {
    const std::uint32_t row = numbers[i];
    if (row == kFrozen) continue;
    unknowns_[row].residual.x -= terms.gradient[2 * i];
    unknowns_[row].residual.y -= terms.gradient[2 * i + 1];
    for (int j = 0; j < kCorners; ++j) {
      if (numbers[j] == kFrozen) continue;
      Block& sum = block(row, numbers[j]);
      sum[0] += terms.matrix[2 * i][2 * j];
      sum[1] += terms.matrix[2 * i + 1][2 * j];
      sum[2] += terms.matrix[2 * i][2 * j + 1];
      sum[3] += terms.matrix[2 * i + 1][2 * j + 1];
    }
  }
}

// Each face once: at its corner of lowest number.
void SquareStep::assemble() {
  for (std::uint32_t row = 0; row < unknowns_.size(); ++row) {
    for_each_side_around(*mesh_, unknowns_[row].vertex, [&](SideId s) {
      const FaceId f = s.face();
      const int corners = mesh_->corner_count(f);
      for (int k = 0; k < corners; ++k)
        if (unknown_of(mesh_->corner(f, k)) < row) return;
      if (corners == 4)
        add_face<4>(f);
      else
        add_face<3>(f);
    });
  }
}

// Raises the diagonal, inverts it, and turns the residuals of sliding vertices along their pieces. The
// inverse of a sliding vertex acts along its piece alone, so that the iteration never leaves it.
void SquareStep::finish_diagonal() {
  const float raise = 1 + kDamping;
  for (std::uint32_t row = 0; row < unknowns_.size(); ++row) {
    Unknown& u = unknowns_[row];
    Block& d = blocks_[row_starts_[row]];
    d[0] *= raise;
    d[3] *= raise;
    const Pair t = u.along;
    if (t.x != 0 || t.y != 0) {
      const float c = 1 / (t.x * (d[0] * t.x + d[2] * t.y) + t.y * (d[1] * t.x + d[3] * t.y));
      u.inverse = {t.x * t.x * c, t.x * t.y * c, t.y * t.y * c};
    } else {
      const float c = 1 / (d[0] * d[3] - d[1] * d[2]);
      u.inverse = {d[3] * c, -d[1] * c, d[0] * c};
    }
  }
}

// z = M^-1 r; returns r z.
double SquareStep::precondition() {
  double sum = 0;
  for (Unknown& u : unknowns_) {
    const Pair r = u.residual;
    u.preconditioned = {u.inverse[0] * r.x + u.inverse[1] * r.y, u.inverse[1] * r.x + u.inverse[2] * r.y};
    sum += static_cast<double>(u.preconditioned.x * r.x + u.preconditioned.y * r.y);
  }
  return sum;
}

// q = A p; returns p q.
double SquareStep::multiply() {
  double sum = 0;
  for (std::size_t row = 0; row < unknowns_.size(); ++row) {
    float lanes[4] = {0, 0, 0, 0};
    for (std::uint32_t k = row_starts_[row]; k < row_starts_[row + 1]; ++k) {
      const Block& b = blocks_[k];
      const Pair p = direction_[columns_[k]];
      lanes[0] += b[0] * p.x;
      lanes[1] += b[1] * p.x;
      lanes[2] += b[2] * p.y;
      lanes[3] += b[3] * p.y;
    }
    const Pair q{lanes[0] + lanes[2], lanes[1] + lanes[3]};
    product_[row] = q;
    sum += static_cast<double>(q.x * direction_[row].x + q.y * direction_[row].y);
  }
  return sum;
}

void SquareStep::iterate() {
  direction_.resize(unknowns_.size());
  product_.resize(unknowns_.size());
  double rz = precondition();
  const double enough = kReduction * kReduction * rz;
  for (std::size_t i = 0; i < unknowns_.size(); ++i) direction_[i] = unknowns_[i].preconditioned;
  for (int iteration = 0; iteration < kIterations && rz > enough; ++iteration) {
    const double pq = multiply();
    if (!(pq > 0)) break;  // rounding has eaten what there was
    const auto alpha = static_cast<float>(rz / pq);
    for (std::size_t i = 0; i < unknowns_.size(); ++i) {
      Unknown& u = unknowns_[i];
      u.step.x += alpha * direction_[i].x;
      u.step.y += alpha * direction_[i].y;
      u.residual.x -= alpha * product_[i].x;
      u.residual.y -= alpha * product_[i].y;
    }
    const double after = precondition();
    const auto beta = static_cast<float>(after / rz);
    rz = after;
    for (std::size_t i = 0; i < unknowns_.size(); ++i) {
      const Pair z = unknowns_[i].preconditioned;
      direction_[i] = {z.x + beta * direction_[i].x, z.y + beta * direction_[i].y};
    }
  }
}

void SquareStep::solve(VertexId begin, VertexId end, const std::vector<std::uint8_t>& active) {
  choose_unknowns(begin, end, active);
  if (unknowns_.empty()) return;
  lay_out_rows();
  assemble();
  finish_diagonal();
  iterate();
}

}  // namespace quarry
