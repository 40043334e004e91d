#include "io/mesh/number_index.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "engine/base/random.hpp"

namespace quarry {
namespace {

void expect_found(const std::vector<std::int64_t>& numbers) {
  NumberIndex index;
  for (std::uint32_t i = 0; i < numbers.size(); ++i) ASSERT_TRUE(index.add(numbers[i], i)) << numbers[i];
  for (std::uint32_t i = 0; i < numbers.size(); ++i) {
    EXPECT_EQ(index.find(numbers[i]), i);
    EXPECT_FALSE(index.add(numbers[i], 7)) << numbers[i];
  }
  for (const std::int64_t absent : {std::int64_t{-7}, std::int64_t{5000001}, std::int64_t{1} << 60})
    EXPECT_EQ(index.find(absent), NumberIndex::kNone);
}

TEST(NumberIndex, FindsNumbersInAnyOrderAndOfAnySize) {
  std::vector<std::int64_t> numbers;
  for (std::int64_t i = 0; i < 20000; ++i) numbers.push_back(200000 + i);
  expect_found(numbers);  // too far out at first, near enough later
  std::reverse(numbers.begin(), numbers.end());
  expect_found(numbers);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = static_cast<std::int64_t>(mix64(i)) | (std::int64_t{1} << 61);
  numbers.insert(numbers.end(), {0, -1, 1, 4095, 4096, std::int64_t{1} << 40});
  expect_found(numbers);
}

}  // namespace
}  // namespace quarry
