#include "io/text_parts.hpp"

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "io/text_cursor.hpp"

namespace quarry {
namespace {

std::string numbered_lines(int count, const std::string& indent) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += fmt::format("{}{} {}\n", i % 7 == 0 ? indent : "  ", i, std::string(40, '.'));
  return text;
}

TEST(TextParts, AreWholeLinesThatCoverTheText) {
  const std::string text = numbered_lines(30000, "  f");
  for (const std::string_view starts : {"", "fg"}) {
    const std::vector<TextPart> parts = split_lines(text, 10, starts);
    ASSERT_GT(parts.size(), 3U);
    EXPECT_EQ(parts.front().begin, 10U);
    EXPECT_EQ(parts.back().end, text.size());
    for (std::size_t k = 1; k < parts.size(); ++k) {
      EXPECT_EQ(parts[k].begin, parts[k - 1].end);
      EXPECT_EQ(text[parts[k].begin - 1], '\n');
      if (!starts.empty()) {
        EXPECT_EQ(text.substr(parts[k].begin, 3), "  f");
      }
    }
  }
}

TEST(TextParts, AreOneWhereNoLineMayStartAnother) {
  EXPECT_EQ(split_lines(numbered_lines(30000, "  f"), 0, "g").size(), 1U);
  EXPECT_EQ(split_lines(std::string(2000000, 'x'), 0).size(), 1U);
  EXPECT_TRUE(split_lines("abc\n", 4).empty());
  EXPECT_TRUE(split_lines("", 0).empty());
}

TEST(TextParts, TellOfTheFirstOfSeveralErrors) {
  try {
    read_parts(100, [](std::size_t i) {
      if (i % 30 == 29) throw Error(ErrorKind::kInput, fmt::format("part {}", i));
    });
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.message(), "part 29");
  }
}

TEST(TextParts, KeepTheNumbersOfTheirLines) {
  const std::string text = "a\nb\nc\nd\n";
  TextCursor cursor("file", text, {4, 6});
  EXPECT_EQ(cursor.word(), "c");
  try {
    cursor.fail("message");
  } catch (const Error& error) {
    EXPECT_EQ(error.message(), "file:3: message");
  }
  EXPECT_TRUE(cursor.at_end());
}

}  // namespace
}  // namespace quarry
