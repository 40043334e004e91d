#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include <fmt/format.h>
#include <hdf5.h>

#include "engine/base/error.hpp"
#include "engine/parallel/parallel.hpp"
#include "io/atomic_file.hpp"
#include "io/mesh/vtkhdf_format.hpp"
#include "io/mesh/vtu_array.hpp"

namespace quarry {
namespace {

// Items of an array that are made at a time, and those of a chunk where it is compressed: part of the output.
constexpr std::size_t kBatchItems = std::size_t{1} << 20;
constexpr std::size_t kChunkItems = std::size_t{1} << 16;
constexpr unsigned kDeflateLevel = 3;

// An object of the library, closed when it goes.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;

  operator hid_t() const { return id_; }  // NOLINT: the library's functions take it

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

class VtkhdfWriter {
 public:
  // The library writes into the file's place before it is put where it belongs.
  VtkhdfWriter(const std::string& path, bool compress) : path_(path), compress_(compress), file_(path) {
    // The library prints errors by itself unless it is told not to.
    check(H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr));
  }

  void write(const Mesh& mesh, const MeshWriteOptions& options) {
    const LiveNumbering numbering(mesh);
    const VtuArrays arrays = make_vtu_arrays(mesh, numbering, options, IndexWidth::kWide);
    {
      const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
      check(H5Pset_libver_bounds(access, H5F_LIBVER_EARLIEST, H5F_LIBVER_V18));
      Handle file(held(H5Fcreate(file_.temporary().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access)), H5Fclose);
      write_grid(file, arrays, options);
      check(H5Fflush(file, H5F_SCOPE_GLOBAL));
    }
    file_.commit();
  }

 private:
  [[noreturn]] void fail() const {
    throw Error(ErrorKind::kOutput,
                fmt::format("{}: cannot be written by the HDF5 library; is the disk full?", path_));
  }
  void check(herr_t status) const {
    if (status < 0) fail();
  }
  [[nodiscard]] hid_t held(hid_t id) const {
    if (id < 0) fail();
    return id;
  }

  [[nodiscard]] Handle make_group(hid_t parent, const char* name) const {
    const Handle properties(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
    check(H5Pset_obj_track_times(properties, false));
    return {held(H5Gcreate2(parent, name, H5P_DEFAULT, properties, H5P_DEFAULT)), H5Gclose};
  }

  void write_grid(hid_t file, const VtuArrays& arrays, const MeshWriteOptions& options) {
    const Handle root = make_group(file, "VTKHDF");
    write_attributes(root);
    const VtuArray& connectivity = arrays.cells[0];
    write_number(root, "NumberOfPoints", arrays.points.items);
    write_number(root, "NumberOfCells", arrays.cells[2].items);
    write_number(root, "NumberOfConnectivityIds", connectivity.items);
    write_array(root, "Points", arrays.points);
    write_array(root, "Connectivity", connectivity);
    write_array(root, "Offsets", from_zero(arrays.cells[1]));
    write_array(root, "Types", arrays.cells[2]);
    if (!arrays.point_data.empty()) {
      const Handle point_data = make_group(root, "PointData");
      for (const VtuArray& array : arrays.point_data) write_array(point_data, array.name.c_str(), array);
    }
    const Handle cell_data = make_group(root, "CellData");
    for (const VtuArray& array : arrays.cell_data) write_array(cell_data, array.name.c_str(), array);
    if (options.fields.empty()) return;
    const Handle field_data = make_group(root, "FieldData");
    for (const FieldText& field : options.fields) write_text(field_data, field);
  }

  // ParaView 5.11 looks for the type as a string of fixed length.
  void write_attributes(hid_t root) const {
    const hsize_t two = 2;
    const Handle pair(held(H5Screate_simple(1, &two, nullptr)), H5Sclose);
    const Handle version(held(H5Acreate2(root, "Version", H5T_STD_I64LE, pair, H5P_DEFAULT, H5P_DEFAULT)),
                         H5Aclose);
    const std::array<std::int64_t, 2> numbers = {1, 0};
    check(H5Awrite(version, H5T_NATIVE_INT64, numbers.data()));
    constexpr std::string_view kType = "UnstructuredGrid";
    const Handle text(held(H5Tcopy(H5T_C_S1)), H5Tclose);
    check(H5Tset_size(text, kType.size()));
    check(H5Tset_strpad(text, H5T_STR_NULLPAD));
    const Handle scalar(held(H5Screate(H5S_SCALAR)), H5Sclose);
    const Handle type(held(H5Acreate2(root, "Type", text, scalar, H5P_DEFAULT, H5P_DEFAULT)), H5Aclose);
    check(H5Awrite(type, text, kType.data()));
  }

  // The place of each cell in the connectivity: the file wants that of the first too.
  static VtuArray from_zero(const VtuArray& ends) {
    VtuArray starts = ends;
    starts.items += 1;
    starts.fill = [fill = ends.fill](std::size_t begin, std::size_t end, std::byte* out) {
      if (begin == 0) {
        std::fill_n(out, sizeof(std::int64_t), std::byte{0});
        out += sizeof(std::int64_t);
        ++begin;
      }
      if (begin < end) fill(begin - 1, end - 1, out);
    };
    return starts;
  }

  static hid_t type_of(const VtuArray& array) {
    if (array.type == "Float64") return H5T_IEEE_F64LE;
    if (array.type == "Int64") return H5T_STD_I64LE;
    if (array.type == "Int32") return H5T_STD_I32LE;
    return H5T_STD_U8LE;
  }

  [[nodiscard]] Handle make_dataset(hid_t group, const char* name, hid_t type, hid_t space, bool compressed,
                                    int components) const {
    const Handle properties(held(H5Pcreate(H5P_DATASET_CREATE)), H5Pclose);
    check(H5Pset_obj_track_times(properties, false));
    // All of it is written; the library refuses that of texts of any length.
    if (H5Tget_class(type) != H5T_STRING) check(H5Pset_fill_time(properties, H5D_FILL_TIME_NEVER));
    if (compressed) {
      const hsize_t chunk[] = {kChunkItems, static_cast<hsize_t>(components)};
      check(H5Pset_chunk(properties, components > 1 ? 2 : 1, chunk));
      check(H5Pset_shuffle(properties));
      check(H5Pset_deflate(properties, kDeflateLevel));
    }
    return {held(H5Dcreate2(group, name, type, space, H5P_DEFAULT, properties, H5P_DEFAULT)), H5Dclose};
  }

  void write_array(hid_t group, const char* name, const VtuArray& array) const {
    const int rank = array.components > 1 ? 2 : 1;
    const hsize_t size[] = {array.items, static_cast<hsize_t>(array.components)};
    const Handle space(held(H5Screate_simple(rank, size, nullptr)), H5Sclose);
    // A chunk may not be larger than what it is a part of.
    const Handle dataset = make_dataset(group, name, type_of(array), space,
                                        compress_ && array.items >= kChunkItems, array.components);
    std::vector<std::byte> buffer(std::min(array.items, kBatchItems) * array.item_bytes);
    for (std::size_t first = 0; first < array.items; first += kBatchItems) {
      const std::size_t items = std::min(array.items - first, kBatchItems);
      parallel::for_each_chunk(items, kChunkItems, [&](std::size_t begin, std::size_t end) {
        array.fill(first + begin, first + end, buffer.data() + begin * array.item_bytes);
      });
      const hsize_t start[] = {first, 0}, count[] = {items, static_cast<hsize_t>(array.components)};
      check(H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, count, nullptr));
      const Handle memory(held(H5Screate_simple(rank, count, nullptr)), H5Sclose);
      check(H5Dwrite(dataset, type_of(array), memory, space, H5P_DEFAULT, buffer.data()));
    }
  }

  void write_number(hid_t group, const char* name, std::uint64_t value) const {
    const hsize_t one = 1;
    const Handle space(held(H5Screate_simple(1, &one, nullptr)), H5Sclose);
    const Handle dataset = make_dataset(group, name, H5T_STD_I64LE, space, false, 1);
    check(H5Dwrite(dataset, H5T_NATIVE_UINT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, &value));
  }

  void write_text(hid_t group, const FieldText& field) const {
    const hsize_t one = 1;
    const Handle space(held(H5Screate_simple(1, &one, nullptr)), H5Sclose);
    const Handle text(held(H5Tcopy(H5T_C_S1)), H5Tclose);
    check(H5Tset_size(text, H5T_VARIABLE));
    const Handle dataset = make_dataset(group, field.name.c_str(), text, space, false, 1);
    const char* const value = field.text.c_str();
    check(H5Dwrite(dataset, text, H5S_ALL, H5S_ALL, H5P_DEFAULT, &value));
  }

  std::string path_;
  bool compress_;
  AtomicFile file_;
};

}  // namespace

void write_vtkhdf(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options) {
  VtkhdfWriter(path, options.compress).write(mesh, options);
}

}  // namespace quarry
