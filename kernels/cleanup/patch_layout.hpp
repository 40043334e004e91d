// The quads of a filled patch, and the lines and grids along which its new vertices are placed, in local
// numbers: 0 to the length of the rim for the rim (counter-clockwise, the patch on its left), then one number
// for each new vertex.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/cleanup/patch_fill.hpp"
#include "kernels/cleanup/patch_ring.hpp"

namespace quarry {

class PatchLayout {
 public:
  using Quad = std::array<std::uint32_t, 4>;
  // Vertices placed evenly between the first and the last of a run of `chains`.
  struct Line {
    std::uint32_t begin, count;
  };
  // columns + 1 by rows + 1 vertices of `grids` from begin on, row by row; the inner ones are placed from the
  // four border lines.
  struct Grid {
    std::uint32_t begin, columns, rows;
  };
  // The defect: placed at the mean of the ends of its spokes. It has no ends in a plain grid.
  struct Centre {
    std::uint32_t vertex = 0;
    std::array<std::uint32_t, 6> ends{};
    std::uint32_t count = 0;
    std::uint32_t lines_before = 0;  // so many lines are placed before it; those after it end in it
  };

  // rim: length of the rim. cuts: made one after the other. corners: places of the corners on the ring that
  // is left, ascending, as many as sides; side i runs from corner i to the next one. Keeps its memory from
  // one patch to the next.
  void build(const PatchFill& fill, std::uint32_t rim, std::span<const PatchCut> cuts,
             std::span<const std::uint32_t> corners);

  [[nodiscard]] std::span<const Quad> quads() const { return quads_; }
  [[nodiscard]] std::uint32_t rim() const { return rim_; }
  [[nodiscard]] std::uint32_t vertices() const { return vertices_; }  // rim included
  [[nodiscard]] const Centre& centre() const { return centre_; }
  [[nodiscard]] std::span<const Line> lines() const { return lines_; }
  [[nodiscard]] std::span<const std::uint32_t> members(const Line& line) const {
    return std::span(chains_).subspan(line.begin, line.count);
  }
  [[nodiscard]] std::span<const Grid> grids() const { return grids_; }
  [[nodiscard]] std::span<const std::uint32_t> members(const Grid& grid) const {
    return std::span(grid_ids_).subspan(grid.begin, std::size_t{grid.columns + 1} * (grid.rows + 1));
  }

 private:
  using Chain = std::vector<std::uint32_t>;

  void add_cut(const PatchCut& cut);
  [[nodiscard]] Chain side_chain(std::span<const std::uint32_t> corners, std::size_t side) const;
  [[nodiscard]] Chain new_line(std::uint32_t from, std::uint32_t to, std::uint32_t edges);
  void add_grid(std::span<const std::uint32_t> bottom, std::span<const std::uint32_t> top,
                std::span<const std::uint32_t> left, std::span<const std::uint32_t> right);
  void add_star(std::span<const Chain> sides, std::span<const std::uint32_t> spokes);
  void add_pair(const PatchFill& fill, std::span<const Chain> sides);

  std::uint32_t rim_ = 0, vertices_ = 0;
  PatchRing ring_;  // what is left to be filled
  PatchRing left_;  // memory for the next one
  Centre centre_;
  std::vector<Quad> quads_;
  std::vector<Line> lines_;
  std::vector<Grid> grids_;
  std::vector<std::uint32_t> chains_, grid_ids_;
};

}  // namespace quarry
