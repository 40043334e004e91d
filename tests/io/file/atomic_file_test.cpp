#include "io/atomic_file.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"

namespace quarry {
namespace {

class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "quarry_atomic_XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }
  [[nodiscard]] std::ptrdiff_t entries() const {
    return std::distance(std::filesystem::directory_iterator(path_), std::filesystem::directory_iterator());
  }

 private:
  std::filesystem::path path_;
};

std::string content(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(AtomicFile, AppearsWholeOnCommit) {
  const Folder folder;
  const std::string path = folder.file("out.txt");
  std::string text;
  for (int i = 0; i < 300'000; ++i) text += "0123456789";
  AtomicFile file(path);
  file.write(text);
  EXPECT_FALSE(std::filesystem::exists(path));
  file.commit();
  EXPECT_EQ(content(path), text);
  EXPECT_EQ(folder.entries(), 1);
}

TEST(AtomicFile, LeavesNoTraceWithoutCommit) {
  const Folder folder;
  const std::string path = folder.file("out.txt");
  write_file(path, "old");
  {
    AtomicFile file(path);
    file.write("new");
  }
  EXPECT_EQ(content(path), "old");
  EXPECT_EQ(folder.entries(), 1);
}

TEST(AtomicFile, ReplacesAnExistingFile) {
  const Folder folder;
  const std::string path = folder.file("out.txt");
  write_file(path, "old");
  write_file(path, "new");
  EXPECT_EQ(content(path), "new");
}

TEST(AtomicFile, NamesThePathAndTheReasonWhenItCannotBeCreated) {
  const Folder folder;
  const std::string path = folder.file("absent/out.txt");
  try {
    const AtomicFile file(path);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kOutput);
    EXPECT_NE(error.message().find(path), std::string::npos);
    EXPECT_NE(error.message().find("No such file"), std::string::npos);
  }
}

TEST(AtomicFile, RefusesAFolder) {
  const Folder folder;
  std::filesystem::create_directory(folder.file("sub"));
  EXPECT_THROW(AtomicFile file(folder.file("sub")), Error);
}

}  // namespace
}  // namespace quarry
