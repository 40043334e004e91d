#include "pipeline/report/input_hash.hpp"

#include <cstdint>

#include <fmt/format.h>

#include "io/input_text.hpp"

namespace quarry {
namespace {

// 64-bit FNV-1a (Fowler, Noll & Vo; RFC 9923).
class Fnv1a {
 public:
  void add(unsigned char byte) { value_ = (value_ ^ byte) * 0x100000001b3ULL; }
  void add_length(std::uint64_t length) {
    for (int shift = 0; shift < 64; shift += 8) add(static_cast<unsigned char>(length >> shift));
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

void add_file(Fnv1a& hash, const std::string& path) {
  const InputText file(path);
  hash.add_length(file.text().size());
  for (const char byte : file.text()) hash.add(static_cast<unsigned char>(byte));
}

}  // namespace

std::string hash_files(const std::vector<std::string>& paths) {
  Fnv1a hash;
  for (const std::string& path : paths) add_file(hash, path);
  return fmt::format("{:016x}", hash.value());
}

}  // namespace quarry
