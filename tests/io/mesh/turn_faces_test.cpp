#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "io/mesh/read_cells.hpp"

namespace quarry {
namespace {

VertexId v(std::size_t i) { return VertexId(i); }

// 3 4 5
// 0 1 2
ReadCells two_squares(FaceCorners left, FaceCorners right) {
  ReadCells cells;
  cells.x = {0, 1, 2, 0, 1, 2};
  cells.y = {0, 0, 0, 1, 1, 1};
  cells.z.assign(6, 0);
  cells.faces = {left, right};
  cells.regions = {0, 0};
  return cells;
}

TEST(TurningFaces, LeavesThoseThatAreCounterClockwise) {
  ReadCells cells = two_squares({v(0), v(1), v(4), v(3)}, {v(1), v(2), v(5), v(4)});
  EXPECT_EQ(turn_counterclockwise("a.msh", cells), 0U);
  EXPECT_EQ(cells.faces[0][1], v(1));
}

TEST(TurningFaces, TurnsAMeshThatIsClockwise) {
  ReadCells cells = two_squares({v(0), v(3), v(4), v(1)}, {v(1), v(4), v(5), v(2)});
  EXPECT_EQ(turn_counterclockwise("a.msh", cells), 2U);
  EXPECT_EQ(cells.faces[0], (FaceCorners{v(0), v(1), v(4), v(3)}));
}

TEST(TurningFaces, TurnsTheFaceThatItsNeighbourContradicts) {
  ReadCells cells = two_squares({v(0), v(1), v(4), v(3)}, {v(1), v(4), v(5), v(2)});
  EXPECT_EQ(turn_counterclockwise("a.msh", cells), 1U);
  EXPECT_EQ(cells.faces[1], (FaceCorners{v(1), v(2), v(5), v(4)}));
}

TEST(TurningFaces, LeavesAFoldedFaceAsItsNeighboursTellIt) {
  // The right square lies folded back over the left one.
  ReadCells cells = two_squares({v(0), v(1), v(4), v(3)}, {v(1), v(2), v(5), v(4)});
  cells.x[2] = 0.5;
  cells.x[5] = 0.5;
  EXPECT_EQ(turn_counterclockwise("a.msh", cells), 0U);
}

TEST(TurningFaces, NamesAPlaceOfABandThatIsTwisted) {
  ReadCells cells;
  for (int i = 0; i < 6; ++i) {
    cells.x.push_back(i);
    cells.y.push_back(i * i);
    cells.z.push_back(0);
  }
  cells.faces = {{v(0), v(1), v(3), v(2)}, {v(2), v(3), v(5), v(4)}, {v(4), v(5), v(0), v(1)}};
  try {
    turn_counterclockwise("a.msh", cells);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    EXPECT_EQ(error.message().find("a.msh: the faces around ("), 0U) << error.message();
  }
}

}  // namespace
}  // namespace quarry
