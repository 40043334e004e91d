#include "io/child_process.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "io/scratch_folder.hpp"

namespace quarry {
namespace {

class Child : public testing::Test {
 protected:
  std::optional<int> run(const std::vector<std::string>& words, const Progress& progress = Progress()) {
    return run_program({words, folder_.file("out"), folder_.file("err")}, progress, limit_);
  }
  [[nodiscard]] std::string written(const std::string& name) const {
    std::ifstream file(folder_.file(name));
    return {std::istreambuf_iterator<char>(file), {}};
  }

  ScratchFolder folder_;
  std::chrono::seconds limit_{60};
};

TEST_F(Child, GivesItsStatusAndWhatItWrites) {
  EXPECT_EQ(run({"sh", "-c", "echo one; echo two >&2; exit 3"}), 3);
  EXPECT_EQ(written("out"), "one\n");
  EXPECT_EQ(written("err"), "two\n");
  EXPECT_EQ(run({"sh", "-c", "kill -9 $$"}), 128 + 9);
}

TEST_F(Child, TakesWordsAsTheyAre) {
  EXPECT_EQ(run({"printf", "%s|", "a b", "$HOME", "; exit 1"}), 0);
  EXPECT_EQ(written("out"), "a b|$HOME|; exit 1|");
}

TEST_F(Child, IsNoneWhereThereIsNoSuchProgram) { EXPECT_EQ(run({"no_such_program_at_all"}), std::nullopt); }

TEST_F(Child, EndsWithItsTimeAndWithTheJob) {
  limit_ = std::chrono::seconds(0);
  try {
    (void)run({"sleep", "60"});
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBudget);
  }
  CancellationToken token;
  token.cancel();
  limit_ = std::chrono::seconds(60);
  try {
    (void)run({"sleep", "60"}, Progress({}, &token));
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInterrupted);
  }
}

TEST(ScratchFolder, GoesWithAllThatIsInIt) {
  std::string path;
  {
    const ScratchFolder folder;
    path = folder.file("");
    std::ofstream(folder.file("a")) << "text";
    EXPECT_TRUE(std::filesystem::exists(path));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace quarry
