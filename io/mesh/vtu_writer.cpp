#include "io/mesh/vtu_writer.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <string_view>

#include <fmt/format.h>
#include <zlib.h>

#include "engine/base/error.hpp"
#include "engine/parallel/parallel.hpp"
#include "io/atomic_file.hpp"
#include "io/mesh/single_edges.hpp"
#include "io/mesh/vtu_array.hpp"
#include "io/xml_text.hpp"

namespace quarry {
namespace {

static_assert(std::endian::native == std::endian::little,
              "files are written in the byte order of the machine");

// Uncompressed bytes of a block: part of the output of compressed files. A batch of blocks is made in
// parallel.
constexpr std::size_t kBlockBytes = std::size_t{1} << 18;
constexpr std::size_t kBlocksInBatch = 32;
// Coordinates hardly shrink more at higher levels, and the rest shrinks enough.
constexpr int kCompressionLevel = 3;

std::vector<const VtuArray*> in_file_order(const VtuArrays& arrays) {
  std::vector<const VtuArray*> order = {&arrays.points};
  for (const VtuArray& array : arrays.cells) order.push_back(&array);
  for (const VtuArray& array : arrays.point_data) order.push_back(&array);
  for (const VtuArray& array : arrays.cell_data) order.push_back(&array);
  return order;
}

// An offset is padded to a fixed width, so that it can be filled in once the sizes of compressed arrays are
// known.
std::string array_element(const VtuArray& array, std::uint64_t offset) {
  return fmt::format(
      "        <DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" {:<30}/>\n",
      array.type, array.name, array.components, fmt::format("offset=\"{}\"", offset));
}

// VTK reads a string as the codes of its characters, ended by 0.
std::string field_element(const std::string& name, std::span<const std::string> texts) {
  std::string codes;
  for (const std::string& text : texts) {
    for (const char c : text) codes += fmt::format("{} ", static_cast<unsigned char>(c));
    codes += "0 ";
  }
  if (!codes.empty()) codes.pop_back();
  return fmt::format(
      "      <DataArray type=\"String\" Name=\"{}\" NumberOfTuples=\"{}\" format=\"ascii\">\n        {}\n"
      "      </DataArray>\n",
      escape_xml(name), texts.size(), codes);
}

// Everything before the binary data; offsets holds one for each array in file order.
std::string header_text(const VtuArrays& arrays, const MeshWriteOptions& options,
                        const std::vector<std::uint64_t>& offsets) {
  auto offset = offsets.begin();
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\"{}>\n"
      "  <UnstructuredGrid>\n",
      options.compress ? " compressor=\"vtkZLibDataCompressor\"" : "");
  if (!options.fields.empty() || !options.groups.empty()) {
    text += "    <FieldData>\n";
    for (const FieldText& field : options.fields) text += field_element(field.name, {&field.text, 1});
    for (const Grouping& group : options.groups) text += field_element(group.tag + "_names", group.names);
    text += "    </FieldData>\n";
  }
  text += fmt::format("    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n      <Points>\n",
                      arrays.points.items, arrays.cell_data.front().items);
  text += array_element(arrays.points, *offset++);
  text += "      </Points>\n      <Cells>\n";
  for (const VtuArray& array : arrays.cells) text += array_element(array, *offset++);
  text += "      </Cells>\n";
  if (!arrays.point_data.empty()) {
    text += "      <PointData>\n";
    for (const VtuArray& array : arrays.point_data) text += array_element(array, *offset++);
    text += "      </PointData>\n";
  }
  text += "      <CellData Scalars=\"region\">\n";
  for (const VtuArray& array : arrays.cell_data) text += array_element(array, *offset++);
  text += "      </CellData>\n    </Piece>\n  </UnstructuredGrid>\n  <AppendedData encoding=\"raw\">\n_";
  return text;
}

void write_integers(AtomicFile& file, const std::vector<std::uint64_t>& values) {
  file.write(std::as_bytes(std::span(values)));
}

// Makes the array in batches of blocks and calls use(batch bytes, items in a block) for each.
template <class Use>
void for_each_batch(const VtuArray& array, std::size_t block_items, Use&& use) {
  std::vector<std::byte> buffer(std::min(array.items, block_items * kBlocksInBatch) * array.item_bytes);
  for (std::size_t first = 0; first < array.items; first += block_items * kBlocksInBatch) {
    const std::size_t items = std::min(array.items - first, block_items * kBlocksInBatch);
    parallel::for_each_chunk(items, block_items, [&](std::size_t begin, std::size_t end) {
      array.fill(first + begin, first + end, buffer.data() + begin * array.item_bytes);
    });
    use(std::span<const std::byte>(buffer).first(items * array.item_bytes));
  }
}

void write_raw(AtomicFile& file, const VtuArray& array) {
  write_integers(file, {array.items * array.item_bytes});
  for_each_batch(array, kBlockBytes / array.item_bytes,
                 [&](std::span<const std::byte> bytes) { file.write(bytes); });
}

void compress_block(std::span<const std::byte> block, std::vector<std::byte>& out) {
  uLongf size = compressBound(static_cast<uLong>(block.size()));
  out.resize(size);
  const int status =
      compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(block.data()),
                static_cast<uLong>(block.size()), kCompressionLevel);
  if (status != Z_OK)
    throw Error(ErrorKind::kBug, fmt::format("zlib cannot compress a block: status {}", status));
  out.resize(size);
}

// The table before the blocks holds their compressed sizes: it is written twice, the second time with the
// sizes.
void write_compressed(AtomicFile& file, const VtuArray& array) {
  const std::size_t block_bytes = kBlockBytes / array.item_bytes * array.item_bytes;
  const std::size_t bytes = array.items * array.item_bytes;
  const std::size_t block_count = (bytes + block_bytes - 1) / block_bytes;
  std::vector<std::uint64_t> table = {block_count, block_bytes, bytes % block_bytes};
  table.resize(3 + block_count, 0);
  const std::size_t table_at = file.size();
  write_integers(file, table);
  std::vector<std::vector<std::byte>> compressed(kBlocksInBatch);
  std::size_t done = 0;
  for_each_batch(array, block_bytes / array.item_bytes, [&](std::span<const std::byte> batch) {
    parallel::for_each_chunk(batch.size(), block_bytes, [&](std::size_t begin, std::size_t end) {
      compress_block(batch.subspan(begin, end - begin), compressed[begin / block_bytes]);
    });
    for (std::size_t i = 0; i * block_bytes < batch.size(); ++i) {
      table[3 + done++] = compressed[i].size();
      file.write(compressed[i]);
    }
  });
  file.overwrite(table_at, std::as_bytes(std::span(table)));
}

void write_numbered(const std::string& path, const Mesh& mesh, const LiveNumbering& numbering,
                    const MeshWriteOptions& options) {
  AtomicFile file(path);
  const VtuArrays arrays = make_vtu_arrays(mesh, numbering, options);
  const std::vector<const VtuArray*> order = in_file_order(arrays);
  std::vector<std::uint64_t> offsets(order.size(), 0);
  const std::size_t data_at = header_text(arrays, options, offsets).size();
  file.write(header_text(arrays, options, offsets));
  for (std::size_t i = 0; i < order.size(); ++i) {
    offsets[i] = file.size() - data_at;
    if (options.compress)
      write_compressed(file, *order[i]);
    else
      write_raw(file, *order[i]);
  }
  file.write("\n  </AppendedData>\n</VTKFile>\n");
  const std::string header = header_text(arrays, options, offsets);
  file.overwrite(0, std::as_bytes(std::span(header.data(), header.size())));
  file.commit();
}

}  // namespace

void write_vtu(const std::string& path, const Mesh& mesh, const MeshWriteOptions& options) {
  LiveNumbering numbering(mesh);
  if (options.consumer != MeshConsumer::kOpenGeoSys) return write_numbered(path, mesh, numbering, options);
  // OpenGeoSys takes each line cell for a part of a fracture, and its tools know no field data that are
  // texts.
  numbering.keep_edges(fracture_edges(mesh, numbering));
  MeshWriteOptions plain = options;
  plain.fields.clear();
  plain.groups.clear();
  write_numbered(path, mesh, numbering, plain);
}

}  // namespace quarry
