// The bytes of a file, read block by block and offered as input iterators to the parser.
#pragma once

#include <cstddef>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include <cerrno>
#include <fmt/format.h>

#include "engine/base/error.hpp"

namespace quarry {

// Throws Error(kInput) with the path and the system's reason when the file cannot be opened or read.
class ByteStream {
 public:
  explicit ByteStream(std::string path)
      : path_(std::move(path)), file_(std::fopen(path_.c_str(), "rb")), block_(std::size_t{1} << 16) {
    if (file_ == nullptr) fail();
    refill();
  }

  // Nothing but white space in the first block, and nothing after it.
  [[nodiscard]] bool blank() const {
    for (std::size_t i = 0; i < size_; ++i)
      if (std::strchr(" \t\r\n", block_[i]) == nullptr || block_[i] == '\0') return false;
    return size_ < block_.size();
  }

  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    explicit Iterator(ByteStream* stream) : stream_(stream) {}
    reference operator*() const { return stream_->block_[stream_->at_]; }
    Iterator& operator++() {
      if (++stream_->at_ == stream_->size_) stream_->refill();
      return *this;
    }
    void operator++(int) { ++*this; }
    // All iterators of a stream stand at the same byte; they differ only in being the end.
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.at_end() == b.at_end(); }
    friend bool operator!=(const Iterator& a, const Iterator& b) { return !(a == b); }

   private:
    [[nodiscard]] bool at_end() const { return stream_ == nullptr || stream_->size_ == 0; }
    ByteStream* stream_;
  };
  Iterator begin() { return Iterator(this); }
  static Iterator end() { return Iterator(nullptr); }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  void refill() {
    errno = 0;
    at_ = 0;
    size_ = std::fread(block_.data(), 1, block_.size(), file_.get());
    if (size_ < block_.size() && std::ferror(file_.get()) != 0) fail();
  }
  [[noreturn]] void fail() const {
    throw Error(ErrorKind::kInput, fmt::format("{}: cannot be read: {}", path_, std::strerror(errno)));
  }

  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
  std::vector<char> block_;
  std::size_t size_ = 0;
  std::size_t at_ = 0;
};

}  // namespace quarry
