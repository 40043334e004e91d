// What the library finds in the files. Readers of others read whole ones in tests/project/mesh_in_readers.py.
#include <gtest/gtest.h>
#include <hdf5.h>

#include "engine/base/error.hpp"
#include "engine/parallel/parallel.hpp"
#include "io/mesh/mesh_format.hpp"
#include "tests/io/mesh/sample_mesh.hpp"
#include "tests/io/mesh/temporary_folder.hpp"

namespace quarry {
namespace {

template <class T>
std::vector<T> read_dataset(const std::string& path, const char* name, hid_t type) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t dataset = H5Dopen2(file, name, H5P_DEFAULT);
  const hid_t space = H5Dget_space(dataset);
  std::vector<T> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  EXPECT_GE(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0) << name;
  H5Sclose(space);
  H5Dclose(dataset);
  H5Fclose(file);
  return values;
}

std::vector<std::int64_t> whole_numbers(const std::string& path, const char* name) {
  return read_dataset<std::int64_t>(path, name, H5T_NATIVE_INT64);
}

TEST(Vtkhdf, HoldsPointsCellsAndTheirValues) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.vtkhdf");
  const std::vector<FaceCorners> faces = {
      {VertexId(std::size_t{0}), VertexId(std::size_t{1}), VertexId(std::size_t{2}),
       VertexId(std::size_t{3})},
      {VertexId(std::size_t{3}), VertexId(std::size_t{2}), VertexId(std::size_t{4}), VertexId()}};
  Mesh mesh = build_mesh({0, 1, 1, 0, 0.5}, {0, 0, 1, 1, 2}, faces);
  auto constraint = mesh.add_tag<EdgeId, std::int32_t>("constraint", -1);
  constraint[mesh.add_edge(VertexId(std::size_t{3}), VertexId(std::size_t{2}))] = 7;
  for (const bool compress : {false, true}) {
    write_mesh(path, mesh, {.fields = {{"options", "size=1"}}, .compress = compress});
    EXPECT_EQ(whole_numbers(path, "VTKHDF/NumberOfPoints"), std::vector<std::int64_t>{5});
    EXPECT_EQ(whole_numbers(path, "VTKHDF/NumberOfCells"), std::vector<std::int64_t>{3});
    EXPECT_EQ(whole_numbers(path, "VTKHDF/NumberOfConnectivityIds"), std::vector<std::int64_t>{9});
    EXPECT_EQ(whole_numbers(path, "VTKHDF/Connectivity"),
              (std::vector<std::int64_t>{0, 1, 2, 3, 3, 2, 4, 3, 2}));
    EXPECT_EQ(whole_numbers(path, "VTKHDF/Offsets"), (std::vector<std::int64_t>{0, 4, 7, 9}));
    EXPECT_EQ(whole_numbers(path, "VTKHDF/Types"), (std::vector<std::int64_t>{9, 5, 3}));
    EXPECT_EQ(whole_numbers(path, "VTKHDF/CellData/constraint"), (std::vector<std::int64_t>{-1, -1, 7}));
    EXPECT_EQ(whole_numbers(path, "VTKHDF/CellData/kind"), (std::vector<std::int64_t>{0, 0, 1}));
    EXPECT_EQ(read_dataset<double>(path, "VTKHDF/Points", H5T_NATIVE_DOUBLE),
              (std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5, 2, 0}));
  }
}

TEST(Vtkhdf, HoldsTheSameInChunksOfManyItems) {
  const TemporaryFolder folder;
  const Mesh mesh = make_sample_mesh({.size = 400});
  write_mesh(folder.file("plain.hdf"), mesh, {});
  write_mesh(folder.file("packed.hdf"), mesh, {.compress = true});
  for (const char* name : {"VTKHDF/Connectivity", "VTKHDF/Offsets", "VTKHDF/Types", "VTKHDF/CellData/region"})
    EXPECT_TRUE(whole_numbers(folder.file("plain.hdf"), name) ==
                whole_numbers(folder.file("packed.hdf"), name))
        << name;
  EXPECT_LT(file_content(folder.file("packed.hdf")).size(),
            file_content(folder.file("plain.hdf")).size() / 2);
}

TEST(Vtkhdf, HasTheSameBytesOnAnyNumberOfThreads) {
  const TemporaryFolder folder;
  const Mesh mesh = make_sample_mesh({.size = 300});
  for (const bool compress : {false, true}) {
    const MeshWriteOptions options{.fields = {{"quarry_version", "0.1.0"}, {"options", "a=1"}},
                                   .compress = compress};
    parallel::with_threads(1, [&] { write_mesh(folder.file("a.hdf"), mesh, options); });
    parallel::with_threads(4, [&] { write_mesh(folder.file("b.hdf"), mesh, options); });
    EXPECT_TRUE(file_content(folder.file("a.hdf")) == file_content(folder.file("b.hdf")));
  }
}

TEST(Vtkhdf, HoldsAnEmptyMesh) {
  const TemporaryFolder folder;
  write_mesh(folder.file("a.hdf"), Mesh(), {});
  EXPECT_EQ(whole_numbers(folder.file("a.hdf"), "VTKHDF/Offsets"), std::vector<std::int64_t>{0});
}

TEST(Vtkhdf, AppearsWholeOrNotAtAllAndIsNotRead) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_mesh(folder.file("absent/a.vtkhdf"), make_sample_mesh({}), {}), Error);
  EXPECT_EQ(folder.entries(), 0);
  try {
    check_readable_extension("a.vtkhdf");
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kUsage);
    EXPECT_NE(error.message().find("is written and not read; read one of .vtu"), std::string::npos);
  }
}

}  // namespace
}  // namespace quarry
