// Numbers of triangles, and which of them count.
#pragma once

#include <concepts>
#include <memory>
#include <type_traits>

#include "engine/base/id.hpp"

namespace quarry {

using TriangleId = Id<struct TriangleKind>;  // of a triangulated surface, in its own order

// A reference to a predicate over triangles, which must outlive it; a function of the triangle alone. Without
// one, all triangles pass.
class TriangleFilter {
 public:
  TriangleFilter() = default;
  // Implicit, so that a lambda may be given where a filter is wanted.
  template <std::predicate<TriangleId> Predicate>
    requires(!std::is_same_v<std::remove_cvref_t<Predicate>, TriangleFilter>)
  TriangleFilter(const Predicate& keep)
      : object_(std::addressof(keep)), call_([](const void* object, TriangleId triangle) -> bool {
          return (*static_cast<const Predicate*>(object))(triangle);
        }) {}

  [[nodiscard]] bool operator()(TriangleId triangle) const {
    return call_ == nullptr || call_(object_, triangle);
  }

 private:
  const void* object_ = nullptr;
  bool (*call_)(const void*, TriangleId) = nullptr;
};

}  // namespace quarry
