// A bounding volume hierarchy over boxes of floats, by Embree, which is named nowhere else. It finds
// candidates: what is in the boxes, in what numbers and how exactly it is judged, only the caller knows. The
// order of visits depends on the processor, so no result may depend on it.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <type_traits>

namespace quarry {

using FloatPoint = std::array<float, 3>;

struct FloatBox {
  FloatPoint low{}, high{};
};

class BoxTree {
 public:
  // instruction_set: "sse2", "sse4.2", "avx", "avx2" or "avx512" of those that the processor has; empty: the
  // best one. Built in parallel by the threads at hand; starts none and limits none. Throws std::bad_alloc,
  // or Error(kBug) with Embree's own words.
  explicit BoxTree(std::span<const FloatBox> boxes, const std::string& instruction_set = {});
  ~BoxTree();
  BoxTree(BoxTree&&) noexcept;
  BoxTree& operator=(BoxTree&&) noexcept;

  // Calls visit(number) for each box within the radius of the point, and for some others. visit returns the
  // radius from then on, which never grows.
  template <class Visit>
  void visit_near(const FloatPoint& point, float radius, Visit&& visit) const {
    near(point, radius, Visitor(visit));
  }

  // Calls visit(number) for each box that the segment origin + [0, length] * direction meets, and for some
  // others; direction has a length of about 1. Rounding may make it miss a box that it meets by less than
  // about 1e-6 of the coordinates. visit returns the length from then on, which never grows.
  template <class Visit>
  void visit_along(const FloatPoint& origin, const FloatPoint& direction, float length, Visit&& visit) const {
    along(origin, direction, length, Visitor(visit));
  }

  // A reference to the visitor, for the other side of the wall.
  class Visitor {
   public:
    template <class Visit>
      requires(!std::is_same_v<std::remove_cvref_t<Visit>, Visitor>)
    explicit Visitor(Visit& visit)
        : object_(const_cast<void*>(static_cast<const void*>(std::addressof(visit)))),
          call_([](void* object, std::uint32_t box) { return (*static_cast<Visit*>(object))(box); }) {}
    float operator()(std::uint32_t box) const { return call_(object_, box); }

   private:
    void* object_;
    float (*call_)(void*, std::uint32_t);
  };

 private:
  struct Scene;
  void near(const FloatPoint& point, float radius, const Visitor& visit) const;
  void along(const FloatPoint& origin, const FloatPoint& direction, float length, const Visitor& visit) const;

  std::unique_ptr<Scene> scene_;
};

}  // namespace quarry
