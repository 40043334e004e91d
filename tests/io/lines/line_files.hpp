// What tests of readers of lines have in common: a folder for their files, what was read, and errors.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "engine/base/error.hpp"
#include "engine/base/log.hpp"
#include "io/lines/line_reader.hpp"

namespace quarry {

class LineFiles : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "quarry_lines_XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string save(const std::string& text, const std::string& name) {
    const std::string path = (folder_ / name).string();
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }
  LineSet read(const std::string& text, const std::string& name) { return read_lines({save(text, name)}); }

  // The message of the kInput error that reading must end in: one line that names the file.
  static std::string error_of_path(const std::string& path) {
    try {
      (void)read_lines({path});
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kInput);
      EXPECT_NE(error.message().find(path), std::string::npos) << error.message();
      EXPECT_EQ(error.message().find('\n'), std::string::npos) << error.message();
      return error.message();
    }
    ADD_FAILURE() << "no error";
    return {};
  }
  std::string error_of(const std::string& text, const std::string& name) {
    return error_of_path(save(text, name));
  }

  // Every beginning of a text, and every text with one byte changed, must end in lines or in an error.
  void expect_survival(const std::string& whole, const std::string& name) {
    log::set_level(log::Level::kQuiet);
    for (std::size_t i = 0; i < whole.size(); ++i) {
      attempt(save(whole.substr(0, i), name));
      for (const char byte : {'[', '(', ')', '"', ',', ';', '9', '-', ' ', '\n', '\r', '\0', '\xff'}) {
        std::string changed = whole;
        changed[i] = byte;
        attempt(save(changed, name));
      }
    }
    log::set_level(log::Level::kNormal);
  }

  std::filesystem::path folder_;

 private:
  static void attempt(const std::string& path) {
    try {
      (void)read_lines({path});
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kInput) << error.message();
    }
  }
};

using Points = std::vector<Vec2>;

inline const Points& points_of(const LineSet& lines, std::size_t i) { return lines.lines[LineId(i)].points; }

}  // namespace quarry

#define EXPECT_MESSAGE(message, part) EXPECT_NE((message).find(part), std::string::npos) << (message)
