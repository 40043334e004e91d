// Surfaces as published by others, with the counts that others found in them; skipped where they are absent.
#include <filesystem>

#include <gtest/gtest.h>

#include "io/mesh/mesh_format.hpp"

namespace quarry {
namespace {

struct RealSurface {
  const char* path;
  std::size_t points, faces;
};

void PrintTo(const RealSurface& surface, std::ostream* out) { *out << surface.path; }

class RealSurfaces : public testing::TestWithParam<RealSurface> {};

TEST_P(RealSurfaces, AreReadWhole) {
  const std::string path = std::string("../shared/data/") + GetParam().path;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
  const ReadCells cells = read_cells(path);
  EXPECT_EQ(cells.x.size(), GetParam().points);
  EXPECT_EQ(cells.faces.size(), GetParam().faces);
  EXPECT_EQ(cells.regions.size(), GetParam().faces);
}

INSTANTIATE_TEST_SUITE_P(
    All, RealSurfaces,
    testing::Values(
        RealSurface{"surface/boot_scan.obj", 19931, 39906},
        RealSurface{"surface/hammer_scan.obj", 30082, 60160},
        RealSurface{"surface/mountain_terrain.obj", 25600, 50562},
        RealSurface{"surface/demosthenes_low.obj", 8394, 16719},
        RealSurface{"surface/pizza_scan.obj", 24916, 49954}, RealSurface{"surface/koala_low.obj", 3560, 7116},
        RealSurface{"surface/skull_low.obj", 5154, 10312},
        RealSurface{"surface/plane_holes.obj", 8519, 16747}, RealSurface{"surface/wingnut.obj", 3047, 6090},
        RealSurface{"surface/featuretype_cad.stl", 2010, 3476},
        RealSurface{"surface/tray_bottom_cad.stl", 2216, 4520},
        RealSurface{"surface/cycloidal_cad.ply", 21384, 43368},
        RealSurface{"surface/idler_riser_cad.stl", 803, 1572}, RealSurface{"surface/fandisk.obj", 2877, 5750},
        RealSurface{"surface/fault_oak_ridge_500m.ts", 10414, 20277},
        RealSurface{"surface/fault_oak_ridge_500m.obj", 10414, 20277},
        RealSurface{"surface/fault_channel_islands_native.ts", 393, 715},
        RealSurface{"surface/fault_channel_islands_native.obj", 393, 715},
        RealSurface{"surface/fault_ridgecrest_native.ts", 8103, 14112},
        RealSurface{"surface/fault_ridgecrest_native.obj", 8103, 14112},
        RealSurface{"surface/structmodel_a1.ml", 5130, 7944},
        RealSurface{"surface/structmodel_a1.obj", 5130, 7944}, RealSurface{"surface/spot.obj", 829, 1654},
        RealSurface{"ugly/hourglass_ico.obj", 23, 40}, RealSurface{"ugly/triple_vierbein.obj", 75, 108},
        RealSurface{"ugly/moebius.obj", 280, 224}, RealSurface{"ugly/lego.ply", 1649, 3072},
        RealSurface{"ugly/busted.stl", 1941, 3878}, RealSurface{"ugly/adis16480.stl", 3672, 7436},
        RealSurface{"ugly/nonmanifold_crash.obj", 717, 1442},
        RealSurface{"ugly/self_intersect_a.obj", 8582, 17160}, RealSurface{"ugly/offset1.obj", 2287, 4418},
        RealSurface{"ugly/face_holes.off", 4291, 8288}, RealSurface{"ugly/elephant_holes.off", 2798, 4463}));

}  // namespace
}  // namespace quarry
