// Named, typed, dense data of vertices, edges or faces. Tags follow the mesh: they grow, are permuted and
// shrink with the entities that they describe.
#pragma once

#include <cassert>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/base/id.hpp"

namespace quarry {

class TagBase {
 public:
  explicit TagBase(std::string name) : name_(std::move(name)) {}
  virtual ~TagBase() = default;
  TagBase(const TagBase&) = delete;
  TagBase& operator=(const TagBase&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  virtual void resize(std::size_t size) = 0;
  // Keeps value old_of[i] as value i.
  virtual void gather(std::span<const std::uint32_t> old_of) = 0;
  [[nodiscard]] virtual std::size_t bytes() const = 0;

 private:
  std::string name_;
};

template <class IdType, class T>
class TagData final : public TagBase {
 public:
  TagData(std::string name, std::size_t size, T initial)
      : TagBase(std::move(name)), initial_(initial), values_(size, initial) {}

  void resize(std::size_t size) override { values_.resize(size, initial_); }
  void gather(std::span<const std::uint32_t> old_of) override {
    IdVector<IdType, T> kept(old_of.size());
    for (std::size_t i = 0; i < old_of.size(); ++i) kept[IdType(i)] = values_[IdType(old_of[i])];
    values_ = std::move(kept);
  }
  [[nodiscard]] std::size_t bytes() const override { return values_.size() * sizeof(T); }

  [[nodiscard]] IdVector<IdType, T>& values() { return values_; }
  [[nodiscard]] const IdVector<IdType, T>& values() const { return values_; }

 private:
  T initial_;
  IdVector<IdType, T> values_;
};

// A cheap handle to a tag of one mesh; valid as long as the mesh has the tag.
template <class IdType, class T>
class Tag {
 public:
  Tag() = default;
  explicit Tag(TagData<IdType, T>* data) : data_(data) {}

  [[nodiscard]] bool valid() const { return data_ != nullptr; }
  [[nodiscard]] const T& operator[](IdType id) const { return std::as_const(*data_).values()[id]; }
  [[nodiscard]] T& operator[](IdType id) { return data_->values()[id]; }
  [[nodiscard]] IdVector<IdType, T>& values() const { return data_->values(); }

 private:
  TagData<IdType, T>* data_ = nullptr;
};

// The tags of one entity type.
template <class IdType>
class TagSet {
 public:
  template <class T>
  Tag<IdType, T> add(std::string name, std::size_t size, T initial) {
    assert(!find<T>(name).valid());
    auto data = std::make_unique<TagData<IdType, T>>(std::move(name), size, initial);
    Tag<IdType, T> tag(data.get());
    tags_.push_back(std::move(data));
    return tag;
  }
  // The tag of that name and type, or an invalid handle.
  template <class T>
  [[nodiscard]] Tag<IdType, T> find(std::string_view name) const {
    for (const auto& tag : tags_)
      if (tag->name() == name)
        if (auto* data = dynamic_cast<TagData<IdType, T>*>(tag.get())) return Tag<IdType, T>(data);
    return {};
  }
  void remove(std::string_view name) {
    std::erase_if(tags_, [&](const auto& tag) { return tag->name() == name; });
  }
  void resize(std::size_t size) {
    for (const auto& tag : tags_) tag->resize(size);
  }
  void gather(std::span<const std::uint32_t> old_of) {
    for (const auto& tag : tags_) tag->gather(old_of);
  }
  [[nodiscard]] std::size_t bytes() const {
    std::size_t sum = 0;
    for (const auto& tag : tags_) sum += tag->bytes();
    return sum;
  }

 private:
  std::vector<std::unique_ptr<TagBase>> tags_;
};

}  // namespace quarry
