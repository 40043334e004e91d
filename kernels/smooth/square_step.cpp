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

// What a face adds to the system: the derivatives of its residuals by the places of its corners, and from
// them the products. The residuals are those of its corners and its area.
template <int kCorners>
struct FaceTerms {
  static constexpr int kLanes = 2 * kCorners;
  float jacobian[kCorners + 1][kLanes] = {};
  float residuals[kCorners + 1] = {};
  float matrix[kLanes][kLanes] = {};
  float gradient[kLanes] = {};

  static constexpr int next(int k) { return k + 1 < kCorners ? k + 1 : 0; }
  static constexpr int previous(int k) { return k > 0 ? k - 1 : kCorners - 1; }

  void set(int row, int corner, float x, float y) {
    jacobian[row][2 * corner] = x;
    jacobian[row][2 * corner + 1] = y;
  }
  void multiply() {
    for (int r = 0; r <= kCorners; ++r)
      for (int i = 0; i < kLanes; ++i) {
        gradient[i] += jacobian[r][i] * residuals[r];
        for (int j = 0; j < kLanes; ++j) matrix[i][j] += jacobian[r][i] * jacobian[r][j];
      }
  }
  // |a - b|^2 * weight of the ends of each edge; edges: from each corner to the next.
  void add_springs(float weight, const float (&x)[kCorners], const float (&y)[kCorners]) {
    for (int k = 0; k < kCorners; ++k) {
      const int a = 2 * k;
      const int b = 2 * next(k);
      for (int d = 0; d < 2; ++d) {
        matrix[a + d][a + d] += weight;
        matrix[b + d][b + d] += weight;
        matrix[a + d][b + d] -= weight;
        matrix[b + d][a + d] -= weight;
        const float pull = weight * (d == 0 ? x[k] : y[k]);
        gradient[a + d] -= pull;
        gradient[b + d] += pull;
      }
    }
  }
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
  using Terms = FaceTerms<kCorners>;
  constexpr bool kQuad = kCorners == 4;
  constexpr auto kCosine = static_cast<float>(kQuad ? kRight.cosine : kSixty.cosine);
  constexpr auto kSine = static_cast<float>(kQuad ? kRight.sine : kSixty.sine);
  Terms terms;
  std::uint32_t numbers[kCorners];
  Vec2 places[kCorners];
  for (int k = 0; k < kCorners; ++k) {
    const VertexId v = mesh_->corner(f, k);
    numbers[k] = unknown_of(v);
    places[k] = mesh_->point(v);
  }
  const double per_unit = 1 / unit_;
  float x[kCorners], y[kCorners], squared[kCorners], lengths[kCorners], inverse[kCorners];
  for (int k = 0; k < kCorners; ++k) {
    const Vec2 edge = per_unit * (places[Terms::next(k)] - places[k]);
    x[k] = static_cast<float>(edge.x);
    y[k] = static_cast<float>(edge.y);
  }
  for (int k = 0; k < kCorners; ++k) squared[k] = x[k] * x[k] + y[k] * y[k];
  for (int k = 0; k < kCorners; ++k) lengths[k] = std::sqrt(squared[k]);
  for (int k = 0; k < kCorners; ++k) inverse[k] = 1 / squared[k];
  for (int k = 0; k < kCorners; ++k) {
    const int before = Terms::previous(k);
    // As angle_residual, out = edge k, back = the edge before, reversed.
    const float cosine = -(x[k] * x[before] + y[k] * y[before]);
    const float sine = -(x[k] * y[before] - y[k] * x[before]);
    const float product = lengths[k] * lengths[before];
    const float below = 1 / (product + kCosine * cosine + kSine * sine);
    const float slope = -product * below;
    terms.residuals[k] = (kSine * cosine - kCosine * sine) * below;
    // The angle grows as `next` turns right around the corner and `before` turns left.
    const float out = slope * inverse[k];
    const float back = slope * inverse[before];
    const float next_x = out * y[k], next_y = -out * x[k];
    const float before_x = back * y[before], before_y = -back * x[before];
    terms.set(k, Terms::next(k), next_x, next_y);
    terms.set(k, before, before_x, before_y);
    terms.set(k, k, -next_x - before_x, -next_y - before_y);
  }
  if (!demands_->empty()) {
    // Twice the derivative of the area of a quad by a corner is the diagonal before it, turned left; of a
    // triangle's corner area it is the far edge.
    const Vec2 first = per_unit * (places[2] - places[0]);
    const Vec2 second = per_unit * (places[kQuad ? 3 : 1] - places[kQuad ? 1 : 0]);
    const double area = kQuad ? 0.5 * cross(first, second) : cross(second, first);
    const AreaDemand demand = (*demands_)[f];
    const Residual residual = area_residual(area, {demand.wanted * per_unit * per_unit, demand.weight});
    terms.residuals[kCorners] = static_cast<float>(residual.value);
    const auto slope = static_cast<float>((kQuad ? 0.5 : 1.0) * residual.slope);
    for (int k = 0; k < kCorners; ++k) {
      // places[previous] - places[next]
      const Vec2 across = per_unit * (places[Terms::previous(k)] - places[Terms::next(k)]);
      terms.set(kCorners, k, -slope * static_cast<float>(across.y), slope * static_cast<float>(across.x));
    }
  }
  terms.multiply();
  const float shortest = *std::min_element(squared, squared + kCorners);
  terms.add_springs(0.125F * spring_ * spring_ / shortest, x, y);

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
