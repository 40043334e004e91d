// The size that makes about so many elements, found by making meshes: short pieces and narrow gaps of the
// lines ask for more elements than their area tells.
#pragma once

#include <optional>

namespace quarry {

// How far the number of elements may be from --count, as a share of it, where nothing else decides it.
inline constexpr double kCountTolerance = 0.02;

class CountSearch {
 public:
  // wanted: elements, above 0. size: of the first round, in input units.
  CountSearch(double wanted, double size) : wanted_(wanted), first_size_(size), size_(size) {}

  // elements: what the last size made. Returns the size of the next round; none: the last mesh is the one to
  // keep. No more than kMostRounds come, and one more where an earlier size was better than the last.
  [[nodiscard]] std::optional<double> next(double elements);

  static constexpr int kMostRounds = 6;

 private:
  struct Round {
    double size = 0, elements = 0;
  };
  [[nodiscard]] double miss(const Round& round) const;
  [[nodiscard]] double mended_size(const Round& last) const;
  [[nodiscard]] std::optional<double> end(const Round& last);

  double wanted_, first_size_, size_;
  int rounds_ = 0, in_vain_ = 0;
  bool ended_ = false;
  Round best_, before_;                 // the nearest, and the last but one
  std::optional<Round> above_, below_;  // the nearest of more elements than wanted, and of fewer
};

}  // namespace quarry
