#include "engine/base/id.hpp"

#include <concepts>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace quarry {
namespace {

template <class A, class B>
concept CanCompare = requires(A a, B b) { a == b; } || requires(A a, B b) { a < b; };

template <class Container, class Index>
concept CanIndex = requires(Container c, Index i) { c[i]; };

TEST(Id, ConvertsToAndFromNothingByItself) {
  static_assert(!std::convertible_to<std::uint32_t, VertexId>);
  static_assert(!std::convertible_to<int, VertexId>);
  static_assert(!std::convertible_to<VertexId, std::uint32_t>);
  static_assert(!std::constructible_from<FaceId, VertexId>);
  static_assert(!std::convertible_to<VertexId, FaceId>);
}

TEST(Id, ComparesWithItsOwnKindOnly) {
  static_assert(CanCompare<VertexId, VertexId>);
  static_assert(!CanCompare<VertexId, FaceId>);
  static_assert(!CanCompare<VertexId, EdgeId>);
  static_assert(!CanCompare<VertexId, std::uint32_t>);
  EXPECT_LT(VertexId(1U), VertexId(2U));
}

TEST(Id, IsInvalidUntilItIsGiven) {
  EXPECT_FALSE(VertexId().valid());
  EXPECT_TRUE(VertexId(0U).valid());
}

TEST(IdVector, IsIndexedByItsOwnKindOnly) {
  using Values = IdVector<VertexId, double>;
  static_assert(CanIndex<Values, VertexId>);
  static_assert(!CanIndex<Values, FaceId>);
  static_assert(!CanIndex<Values, std::size_t>);
  static_assert(!CanIndex<Values, int>);
}

TEST(IdVector, GivesTheIdOfWhatIsPushed) {
  IdVector<VertexId, double> values(2, 1.5);
  const VertexId id = values.push_back(2.5);
  EXPECT_EQ(id, VertexId(2U));
  EXPECT_EQ(values[id], 2.5);
}

TEST(IdRange, NamesEachIdOnceInOrder) {
  std::vector<FaceId> seen;
  for (const FaceId face : IdRange<FaceId>(3)) seen.push_back(face);
  EXPECT_EQ(seen, (std::vector{FaceId(0U), FaceId(1U), FaceId(2U)}));
}

}  // namespace
}  // namespace quarry
