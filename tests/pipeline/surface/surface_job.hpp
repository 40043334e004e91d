// Jobs on surfaces that tests make themselves.
#pragma once

#include <cstddef>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/surface/finish_surface.hpp"
#include "pipeline/surface/surface.hpp"
#include "tests/io/mesh/temporary_folder.hpp"
#include "tests/support/modelled_surface.hpp"

namespace quarry {

class SurfaceJob : public testing::Test {
 protected:
  // The surface as a file in OBJ, each group of its own name.
  std::string file_of(const TriangleSurface& surface, const std::string& name = "surface.obj") {
    const std::string path = folder_.file(name);
    std::ofstream file(path);
    file.precision(17);
    for (const Vec3 p : surface.points) file << "v " << p.x << " " << p.y << " " << p.z << "\n";
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      const auto& [a, b, c] = surface.triangles[t];
      file << "g part_" << surface.groups[t] << "\nf " << a + 1 << " " << b + 1 << " " << c + 1 << "\n";
    }
    return path;
  }

  TemporaryFolder folder_;
};

inline SurfaceOptions options_for(const std::string& path, double count,
                                  Elements elements = Elements::kQuad) {
  SurfaceOptions options;
  options.inputs = {path};
  options.count = count;
  options.elements = elements;
  return options;
}

inline double area_of(const Mesh& mesh) {
  double area = 0;
  for (const FaceId f : mesh.faces()) {
    const auto corner = [&](int k) { return mesh.point3(mesh.corner(f, k)); };
    for (int k = 2; k < mesh.corner_count(f); ++k)
      area += 0.5 * length(cross(corner(k - 1) - corner(0), corner(k) - corner(0)));
  }
  return area;
}

// None in a finished mesh.
inline std::size_t count_invalid(const SurfaceResult& result) {
  return find_invalid_on_surface(result.mesh, test::modelled(result.repaired).model, area_of(result.repaired))
      .size();
}

}  // namespace quarry
