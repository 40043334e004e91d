#include "kernels/crossfield/direct_field.hpp"

#include <algorithm>
#include <cmath>

#define EIGEN_MPL2_ONLY
#include <Eigen/SparseCholesky>

#include "engine/base/random.hpp"
#include "engine/parallel/parallel.hpp"

namespace quarry {
namespace {

// Of the diagonal: keeps the matrix definite where a part of the mesh is flat and nothing is given there.
constexpr double kShift = 1e-6;
// Of vertices that are joined to none.
constexpr double kLeastDiagonal = 1e-12;

// What the given fields add to the right-hand side of a level's free vertices.
std::vector<Vec2> right_hand_side(const FieldLevel& level, const std::vector<Vec2>& z) {
  std::vector<Vec2> b(level.size());
  parallel::for_each(
      level.size(),
      [&](std::size_t i) {
        if (level.given[i] != 0) return;
        for (std::uint32_t e = level.first[i]; e < level.first[i + 1]; ++e)
          if (level.given[level.other[e]] != 0)
            b[i] = b[i] + complex_product(level.turn[e], z[level.other[e]]);
      },
      kFieldChunk);
  return b;
}

class DirectSolver {
 public:
  DirectSolver(const FieldLevel& level, std::vector<Vec2>& z)
      : level_(level), z_(z), unknown_(level.size(), FieldLevel::kNone) {
    for (std::uint32_t i = 0; i < level.size(); ++i)
      if (level.given[i] == 0) {
        unknown_[i] = static_cast<std::uint32_t>(rows_.size());
        rows_.push_back(i);
      }
  }

  void run(int inverse_iterations) {
    if (rows_.empty()) return;
    find_parts();
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix());
    const std::vector<Vec2> b = right_hand_side(level_, z_);
    const bool all_driven = std::all_of(driven_.begin(), driven_.end(), [](bool d) { return d; });
    Eigen::VectorXd x(2 * size());
    for (std::size_t k = 0; k < rows_.size(); ++k)
      for (int c = 0; c < 2; ++c)
        x[at(k, c)] = 2 * uniform01(7, 2 * rows_[k] + static_cast<std::uint32_t>(c)) - 1;
    // Parts where something is given have their solution after the first turn; the others go on.
    for (int turn = 0; turn < (all_driven ? 1 : inverse_iterations); ++turn) {
      for (std::size_t k = 0; k < rows_.size(); ++k)
        if (driven_[part_[k]]) {
          x[at(k, 0)] = b[rows_[k]].x;
          x[at(k, 1)] = b[rows_[k]].y;
        }
      x = factors.solve(x);
      normalise(x);
    }
    for (std::size_t k = 0; k < rows_.size(); ++k) z_[rows_[k]] = {x[at(k, 0)], x[at(k, 1)]};
  }

 private:
  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(rows_.size()); }
  [[nodiscard]] static Eigen::Index at(std::size_t k, int c) { return 2 * static_cast<Eigen::Index>(k) + c; }

  // The real symmetric form: a complex entry p + iq is the block (p, -q; q, p).
  [[nodiscard]] Eigen::SparseMatrix<double> matrix() const {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const std::uint32_t i = rows_[k];
      const double diagonal = std::max(level_.diagonal[i], kLeastDiagonal) * (1 + kShift);
      for (int c = 0; c < 2; ++c) entries.emplace_back(at(k, c), at(k, c), diagonal);
      for (std::uint32_t e = level_.first[i]; e < level_.first[i + 1]; ++e) {
        const std::uint32_t j = unknown_[level_.other[e]];
        if (j == FieldLevel::kNone) continue;
        const Vec2 t = level_.turn[e];
        entries.emplace_back(at(k, 0), at(j, 0), -t.x);
        entries.emplace_back(at(k, 0), at(j, 1), t.y);
        entries.emplace_back(at(k, 1), at(j, 0), -t.y);
        entries.emplace_back(at(k, 1), at(j, 1), -t.x);
      }
    }
    Eigen::SparseMatrix<double> m(2 * size(), 2 * size());
    m.setFromTriplets(entries.begin(), entries.end());
    return m;
  }

  // Connected parts of the free vertices, and which of them know of something given.
  void find_parts() {
    part_.assign(rows_.size(), FieldLevel::kNone);
    std::vector<std::uint32_t> open;
    for (std::uint32_t start = 0; start < rows_.size(); ++start) {
      if (part_[start] != FieldLevel::kNone) continue;
      const auto part = static_cast<std::uint32_t>(driven_.size());
      driven_.push_back(false);
      part_[start] = part;
      open.assign(1, start);
      while (!open.empty()) {
        const std::uint32_t i = rows_[open.back()];
        open.pop_back();
        for (std::uint32_t e = level_.first[i]; e < level_.first[i + 1]; ++e) {
          const std::uint32_t j = unknown_[level_.other[e]];
          if (j == FieldLevel::kNone) driven_[part] = true;
          if (j == FieldLevel::kNone || part_[j] != FieldLevel::kNone) continue;
          part_[j] = part;
          open.push_back(j);
        }
      }
    }
  }

  // Each part that nothing is given in, by itself: one would fade against another.
  void normalise(Eigen::VectorXd& x) const {
    std::vector<double> sums(driven_.size());
    for (std::size_t k = 0; k < rows_.size(); ++k)
      sums[part_[k]] += x[at(k, 0)] * x[at(k, 0)] + x[at(k, 1)] * x[at(k, 1)];
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const std::uint32_t part = part_[k];
      if (driven_[part] || !(sums[part] > 0)) continue;
      const double factor = 1 / std::sqrt(sums[part]);
      for (int c = 0; c < 2; ++c) x[at(k, c)] *= factor;
    }
  }

  const FieldLevel& level_;
  std::vector<Vec2>& z_;
  std::vector<std::uint32_t> unknown_;  // of each vertex its number among the free ones
  std::vector<std::uint32_t> rows_;     // the inverse
  std::vector<std::uint32_t> part_;
  std::vector<bool> driven_;
};

}  // namespace

void solve_directly(const FieldLevel& level, int inverse_iterations, std::vector<Vec2>& crosses) {
  DirectSolver(level, crosses).run(inverse_iterations);
}

}  // namespace quarry
