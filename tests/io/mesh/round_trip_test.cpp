// Every format gives back the mesh that was written, and the same bytes on any number of threads.
#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "engine/parallel/parallel.hpp"
#include "io/mesh/mesh_format.hpp"
#include "tests/io/mesh/mesh_comparison.hpp"
#include "tests/io/mesh/sample_mesh.hpp"
#include "tests/io/mesh/temporary_folder.hpp"

namespace quarry {
namespace {

struct Case {
  const char* extension;
  bool compress;
};

class MeshFormat : public testing::TestWithParam<Case> {
 protected:
  [[nodiscard]] std::string path() const { return folder_.file(std::string("mesh") + GetParam().extension); }
  void write(const Mesh& mesh) const {
    MeshWriteOptions options;
    options.fields = {{"quarry_version", "0.1.0"}, {"options", "size=2 note=\"<&>\""}};
    options.compress = GetParam().compress;
    write_mesh(path(), mesh, options);
  }

  TemporaryFolder folder_;
};

TEST_P(MeshFormat, GivesBackTheMeshThatWasWritten) {
  const Mesh mesh = make_sample_mesh({.size = 13, .corner = {6.7e6, 0.1}});
  write(mesh);
  EXPECT_EQ(compared(read_mesh(path())), compared(mesh));
}

TEST_P(MeshFormat, GivesBackAMeshOfManyBlocks) {
  const Mesh mesh = make_sample_mesh({.size = 260});
  write(mesh);
  EXPECT_EQ(compared(read_mesh(path())), compared(mesh));
}

TEST_P(MeshFormat, LeavesOutTombstones) {
  Mesh mesh = make_sample_mesh({.size = 6, .triangles = false});
  // The face of a corner of the square: its vertex at (0, 0) has no other.
  mesh.delete_face(FaceId(std::size_t{0}));
  mesh.delete_vertex(VertexId(std::size_t{0}));
  write(mesh);
  const Mesh back = read_mesh(path());
  EXPECT_EQ(back.count_alive_faces(), 35U);
  EXPECT_EQ(back.vertex_slots(), 48U);
  EXPECT_EQ(compared(back).faces, compared(mesh).faces);
}

TEST_P(MeshFormat, GivesBackASurface) {
  const std::vector<FaceCorners> faces = {{VertexId(std::size_t{0}), VertexId(std::size_t{1}),
                                           VertexId(std::size_t{2}), VertexId(std::size_t{3})}};
  const Mesh mesh = build_mesh({0, 1, 1, 0}, {0, 0, 1, 1}, {0, 0.5, 1, 0.5}, faces);
  write(mesh);
  const Mesh back = read_mesh(path());
  EXPECT_FALSE(back.planar());
  EXPECT_EQ(compared(back), compared(mesh));
}

TEST_P(MeshFormat, WritesAndReadsAnEmptyMesh) {
  write(Mesh());
  EXPECT_EQ(read_mesh(path()).face_slots(), 0U);
}

TEST_P(MeshFormat, WritesTheSameBytesOnAnyNumberOfThreads) {
  const Mesh mesh = make_sample_mesh({.size = 260});
  parallel::with_threads(1, [&] { write(mesh); });
  const std::string one = file_content(path());
  for (const int threads : {2, 4, 7}) {
    const parallel::ParticipationProbe probe;
    parallel::with_threads(threads, [&] { write(mesh); });
    EXPECT_TRUE(file_content(path()) == one) << threads << " threads";
    EXPECT_GT(probe.chunks_of_other_threads(), 0U) << threads << " threads";
  }
}

TEST_P(MeshFormat, LeavesTheOldFileAloneWhenItCannotBeWritten) {
  const std::string target = folder_.file(std::string("absent/mesh") + GetParam().extension);
  try {
    write_mesh(target, make_sample_mesh({}), {});
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kOutput);
    EXPECT_NE(error.message().find(target), std::string::npos);
  }
  EXPECT_EQ(folder_.entries(), 0);
}

TEST_P(MeshFormat, NamesAFileThatIsNotThere) {
  try {
    static_cast<void>(read_mesh(path()));
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    EXPECT_NE(error.message().find(path()), std::string::npos);
  }
}

TEST_P(MeshFormat, RefusesBrokenFilesWithAnError) {
  write(make_sample_mesh({.size = 3}));
  const std::string whole = file_content(path());
  for (std::size_t i = 0; i < 400; ++i) {
    std::string broken = whole;
    if (i % 2 == 0)
      broken.resize(mix64(i) % whole.size());
    else
      broken[mix64(i) % whole.size()] = static_cast<char>(mix64(i + 1));
    const std::string broken_path = folder_.file(std::string("broken") + GetParam().extension, broken);
    try {
      static_cast<void>(read_mesh(broken_path));
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kInput) << error.message();
      EXPECT_EQ(error.message().find(broken_path), 0U) << error.message();
    }
  }
}

TEST_P(MeshFormat, RefusesCoordinatesTooLargeToWorkWith) {
  const std::vector<FaceCorners> faces = {
      {VertexId(std::size_t{0}), VertexId(std::size_t{1}), VertexId(std::size_t{2})}};
  write(build_mesh({0, 1e30, 0}, {0, 0, 1e30}, faces));
  EXPECT_EQ(read_mesh(path()).face_slots(), 1U);
  write(build_mesh({0, 3e30, 0}, {0, 0, 1e30}, faces));
  try {
    static_cast<void>(read_mesh(path()));
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    EXPECT_EQ(error.message(), path() +
                                   ": point 1 has a coordinate that is not a usable number; the largest is "
                                   "1e+30: (3e+30, 0, 0)");
  }
}

INSTANTIATE_TEST_SUITE_P(All, MeshFormat,
                         testing::Values(Case{".vtu", false}, Case{".vtu", true}, Case{".msh", false},
                                         Case{".obj", false}, Case{".inp", false}, Case{".ply", false},
                                         Case{".avs", false}),
                         [](const auto& instance) {
                           return std::string(instance.param.extension + 1) +
                                  (instance.param.compress ? "Compressed" : "");
                         });

TEST(MeshFormats, ThatAreReadOrWrittenAreNamedWhenAnExtensionIsNotKnown) {
  const auto expect_named = [](void (*check)(const std::string&), const std::string& formats) {
    for (const char* path : {"mesh.stp", "mesh"}) {
      try {
        check(path);
        FAIL() << "no error";
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::kUsage);
        EXPECT_NE(error.message().find("is not known; use one of " + formats), std::string::npos)
            << error.message();
      }
    }
  };
  expect_named(check_readable_extension, readable_mesh_formats());
  expect_named(check_writable_extension, writable_mesh_formats());
  EXPECT_EQ(readable_mesh_formats().find(".vtkhdf"), std::string::npos);
  EXPECT_EQ(writable_mesh_formats().find(".off"), std::string::npos);
}

TEST(MeshFormats, AreRefusedWhenTheyAreOnlyRead) {
  for (const char* path : {"mesh.off", "mesh.ts", "mesh.ML"}) {
    EXPECT_NO_THROW(check_readable_extension(path));
    try {
      check_writable_extension(path);
      FAIL() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kUsage);
      EXPECT_NE(
          error.message().find("is read and not written; write one of .vtu, .msh, .obj, .inp, .ply, .stl, "),
          std::string::npos)
          << error.message();
    }
  }
}

TEST(MeshFormats, TakeExtensionsInEitherCase) { EXPECT_NO_THROW(check_readable_extension("A.VTU")); }

}  // namespace
}  // namespace quarry
