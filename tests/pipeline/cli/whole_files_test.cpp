// What was there before stays whole, whatever ends the writing: a signal, caught or not, a full disk.
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>

#include "engine/base/random.hpp"
#include "tests/pipeline/cli/command_run.hpp"

namespace quarry {
namespace {

// A mesh of some megabytes as text.
std::string write_mesh_into(const TestFolder& folder) {
  const std::string mesh = folder / "in.vtu";
  EXPECT_EQ(
      run_quarry({"mesh", kDemoSection, "-o", mesh, "--size", "3", "--cleanup", "none", "-q"}).exit_code, 0);
  return mesh;
}

// Half of the moments lie within the time that the whole takes.
TEST(WholeFiles, AKilledJobLeavesTheOutputBeforeItOrItsOwn) {
  const TestFolder folder;
  const std::string mesh = write_mesh_into(folder);
  ASSERT_EQ(run_quarry({"convert", mesh, folder / "whole.msh"}).exit_code, 0);
  const std::string whole = read_text(folder / "whole.msh");
  const std::string before = "what was there before";
  int killed = 0;
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    const std::string output = folder.write("out.msh", before);
    const int moment = 1 + static_cast<int>(40 * uniform01(7, seed));
    int asked = 0;
    CommandOptions options;
    options.signal = [&](const std::string&) { return ++asked < moment ? 0 : SIGKILL; };
    const CommandResult result = run_quarry({"convert", mesh, output}, options);
    killed += result.exit_code == -1 ? 1 : 0;
    const std::string after = read_text(output);
    EXPECT_TRUE(after == before || after == whole) << "seed " << seed << ": " << after.size() << " bytes";
    EXPECT_TRUE(result.exit_code != 0 || after == whole) << "seed " << seed;
  }
  EXPECT_GT(killed, 0);
}

// Signals come at moments spread over the time that the whole takes: at each the command ends soon, or had
// begun to write.
TEST(WholeFiles, CommandsOnMeshesEndWhenInterruptedAndLeaveTheOutputBefore) {
  const TestFolder folder;
  const std::string mesh = write_mesh_into(folder);
  const std::string before = "what was there before", output = folder / "out";
  const std::vector<std::vector<std::string>> commands = {
      {"convert", mesh, output + ".msh"}, {"picture", mesh, "-o", output + ".svg"}, {"quality", mesh}};
  for (const std::vector<std::string>& command : commands) {
    const std::string path = command.back() == mesh ? "" : command.back();
    int polls = 0;
    CommandOptions options;
    options.signal = [&](const std::string&) { return ++polls, 0; };
    ASSERT_EQ(run_quarry(command, options).exit_code, 0);
    const int most = polls;
    int interrupted = 0;
    // A machine with other work may stand still between the moments that would tell.
    for (int sweep = 0; sweep < 5 && interrupted == 0; ++sweep)
      for (int moment = 1; moment <= most; moment += std::max(1, most / 10)) {
        if (!path.empty()) (void)folder.write(std::filesystem::path(path).filename(), before);
        polls = 0;
        options.signal = [&](const std::string&) { return ++polls < moment ? 0 : SIGINT; };
        const CommandResult result = run_quarry(command, options);
        // At the very beginning the signal ends the process by itself.
        EXPECT_TRUE(result.exit_code == 130 || result.exit_code == 0 || result.exit_code == -1) << result.err;
        if (result.exit_code != 130) continue;
        ++interrupted;
        EXPECT_EQ(result.error_lines(), 1U) << result.err;
        EXPECT_EQ(result.out, "");
        if (!path.empty()) {
          EXPECT_EQ(read_text(path), before);
        }
      }
    EXPECT_GT(interrupted, 0) << command[0];
  }
}

// A file system of a quarter of a megabyte that this process and the command see alone.
class FullDisk : public testing::Test {
 protected:
  void SetUp() override {
    const std::string place = disk_ / ".";
    if (unshare(CLONE_NEWNS) != 0 || mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
        mount("none", place.c_str(), "tmpfs", 0, "size=256k") != 0)
      GTEST_SKIP() << "needs the right to mount a file system";
    mounted_ = true;
  }
  void TearDown() override {
    if (mounted_) umount((disk_ / ".").c_str());
  }

  TestFolder disk_;
  bool mounted_ = false;
};

TEST_F(FullDisk, EndsWithExitCodeSevenAndNothingHalfWritten) {
  const TestFolder folder;
  const std::string mesh = write_mesh_into(folder);
  const std::string before = "what was there before";
  const auto expect_full = [&](std::vector<std::string> arguments, const std::string& name) {
    const CommandResult result = run_quarry(arguments);
    EXPECT_EQ(result.exit_code, 7) << name << ": " << result.err;
    EXPECT_NE(result.err.find(name), std::string::npos) << result.err;
    EXPECT_TRUE(result.err.find("No space left on device") != std::string::npos ||
                result.err.find("is the disk full?") != std::string::npos)
        << result.err;
    EXPECT_EQ(read_text(disk_ / name), before);
    EXPECT_EQ(disk_.names(), std::vector<std::string>{name});
    std::filesystem::remove(disk_ / name);
  };
  for (const std::string name : {"out.vtu", "out.msh", "out.obj", "out.ply", "out.inp", "out.vtkhdf"})
    expect_full({"convert", mesh, disk_.write(name, before)}, name);
  expect_full(
      {"mesh", kDemoSection, "-o", disk_.write("all.vtu", before), "--size", "3", "--cleanup", "none", "-q"},
      "all.vtu");
  expect_full({"generate", "fractures", "--count", "20000", "-o", disk_.write("net.geojson", before), "-q"},
              "net.geojson");
  expect_full({"picture", mesh, "-o", disk_.write("p.png", before)}, "p.png");
}

}  // namespace
}  // namespace quarry
