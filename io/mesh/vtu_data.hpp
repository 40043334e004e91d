// The numbers of one <DataArray> of a .vtu file, however they are stored.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/mesh/xml_element.hpp"

namespace quarry {

class VtuData {
 public:
  // root is the <VTKFile>; its <AppendedData>, if any, is its last child.
  VtuData(std::string path, const XmlElement& root);

  // All values of an array, converted. Throws Error(kInput) naming the array for broken or unknown storage,
  // and for whole numbers that do not fit.
  [[nodiscard]] std::vector<double> doubles(const XmlElement& array) const;
  [[nodiscard]] std::vector<std::int64_t> integers(const XmlElement& array) const;
  // Those of an array of type String: each is the codes of its characters, ended by 0.
  [[nodiscard]] std::vector<std::string> texts(const XmlElement& array) const;

  [[noreturn]] void fail(const XmlElement& array, const std::string& message) const;

 private:
  template <class T>
  std::vector<T> read(const XmlElement& array) const;
  [[nodiscard]] std::string stored_bytes(const XmlElement& array) const;
  [[nodiscard]] std::string uncompressed(const XmlElement& array, std::string_view stored, bool base64) const;
  // Appends the bytes of one block, at most `expected` of them.
  void inflate_block(const XmlElement& array, std::string_view packed, std::uint64_t expected,
                     std::string& bytes) const;
  [[nodiscard]] std::uint64_t header_word(std::string_view bytes, std::size_t index) const;

  std::string path_;
  std::string_view appended_;
  bool appended_base64_ = false;
  bool compressed_ = false;
  std::size_t header_bytes_ = 4;
};

}  // namespace quarry
