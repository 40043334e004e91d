// Strong 32-bit ids and arrays indexed by them. An id converts from no integer and compares with no id of
// another kind, so that a face index can never be used where a vertex index is meant.
#pragma once

#include <cassert>
#include <compare>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace quarry {

template <class Kind>
class Id {
 public:
  using Value = std::uint32_t;
  static constexpr Value kNone = std::numeric_limits<Value>::max();

  // The id of nothing.
  constexpr Id() = default;
  constexpr explicit Id(Value value) : value_(value) {}
  constexpr explicit Id(std::size_t value) : value_(static_cast<Value>(value)) {}

  [[nodiscard]] constexpr Value value() const { return value_; }
  [[nodiscard]] constexpr bool valid() const { return value_ != kNone; }
  friend constexpr auto operator<=>(Id, Id) = default;

 private:
  Value value_ = kNone;
};

using VertexId = Id<struct VertexKind>;
using EdgeId = Id<struct EdgeKind>;
using FaceId = Id<struct FaceKind>;

// A vector whose index is an id.
template <class IdType, class T>
class IdVector {
 public:
  using Index = IdType;
  using Value = T;

  IdVector() = default;
  explicit IdVector(std::size_t size, const T& value = T()) : values_(size, value) {}
  explicit IdVector(std::vector<T> values) : values_(std::move(values)) {}

  T& operator[](IdType id) {
    assert(id.value() < values_.size());
    return values_[id.value()];
  }
  const T& operator[](IdType id) const {
    assert(id.value() < values_.size());
    return values_[id.value()];
  }

  [[nodiscard]] std::size_t size() const { return values_.size(); }
  [[nodiscard]] bool empty() const { return values_.empty(); }
  void reserve(std::size_t size) { values_.reserve(size); }
  void resize(std::size_t size, const T& value = T()) { values_.resize(size, value); }
  void clear() { values_.clear(); }
  void shrink_to_fit() { values_.shrink_to_fit(); }
  IdType push_back(T value) {
    values_.push_back(std::move(value));
    return IdType(values_.size() - 1);
  }

  [[nodiscard]] std::vector<T>& raw() { return values_; }
  [[nodiscard]] const std::vector<T>& raw() const { return values_; }
  auto begin() { return values_.begin(); }
  auto end() { return values_.end(); }
  auto begin() const { return values_.begin(); }
  auto end() const { return values_.end(); }

 private:
  std::vector<T> values_;
};

// All ids from 0 to size, for range-based loops.
template <class IdType>
class IdRange {
 public:
  class Iterator {
   public:
    explicit constexpr Iterator(std::uint32_t value) : value_(value) {}
    constexpr IdType operator*() const { return IdType(value_); }
    constexpr Iterator& operator++() {
      ++value_;
      return *this;
    }
    friend constexpr bool operator==(Iterator, Iterator) = default;

   private:
    std::uint32_t value_;
  };

  explicit constexpr IdRange(std::size_t size) : size_(static_cast<std::uint32_t>(size)) {}
  [[nodiscard]] constexpr Iterator begin() const { return Iterator(0); }
  [[nodiscard]] constexpr Iterator end() const { return Iterator(size_); }

 private:
  std::uint32_t size_;
};

}  // namespace quarry
