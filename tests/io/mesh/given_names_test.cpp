#include "io/mesh/given_names.hpp"

#include <gtest/gtest.h>

namespace quarry {
namespace {

TEST(GivenNames, StayAsTheyAreWhereNothingElseIsCalledSo) {
  GivenNames names(NameForm::kQuoted);
  for (const char* const name : {"main fault", "Main fault", "region_", "region_1_2", "line_a", "outer"})
    EXPECT_EQ(names.add(name), name);
}

TEST(GivenNames, GetAnEndingWhereAGroupHasThemOrQuarryGivesThemItself) {
  GivenNames names(NameForm::kQuoted);
  EXPECT_EQ(names.add("sand"), "sand");
  EXPECT_EQ(names.add("sand_2"), "sand_2");
  EXPECT_EQ(names.add("sand"), "sand_3");
  for (const std::string name : {"region_0", "line_12", "line_3_left", "line_3_right", "line_unnumbered",
                                 "region_unnumbered", "point_7", "outer_boundary"})
    EXPECT_EQ(names.add(name), name + "_2");
}

TEST(GivenNames, OfWordsAreToldApartWithoutBlanksAndCapitals) {
  GivenNames names(NameForm::kWord);
  EXPECT_EQ(names.add("main fault"), "main_fault");
  EXPECT_EQ(names.add("Main,fault"), "Main_fault_2");
  EXPECT_EQ(names.add("Region 1"), "Region_1_2");
}

TEST(GivenNames, InQuotesHaveNoneAndNoEndsOfLines) {
  EXPECT_EQ(GivenNames(NameForm::kQuoted).add("a\n\"b\""), "a 'b'");
}

TEST(FileNames, AreSharedAmongLinesRegionsAndPointsInSetsAlone) {
  const GroupNames given{
      .regions = {{0, "sand"}}, .lines = {{0, "sand"}, {4, "line_0"}}, .points = {{1, "Sand"}}};
  const GroupNames quoted = FileNames(given, NameForm::kQuoted).numbered();
  EXPECT_EQ(quoted.regions.at(0), "sand");
  EXPECT_EQ(quoted.lines.at(0), "sand");
  EXPECT_EQ(quoted.lines.at(4), "line_0_2");
  EXPECT_EQ(quoted.points.at(1), "Sand");
  const GroupNames words = FileNames(given, NameForm::kWord).numbered();
  EXPECT_EQ(words.lines.at(0), "sand");
  EXPECT_EQ(words.regions.at(0), "sand_2");
  EXPECT_EQ(words.points.at(1), "Sand_2");
}

}  // namespace
}  // namespace quarry
