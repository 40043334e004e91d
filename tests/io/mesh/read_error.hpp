// What a reader says of a file that it refuses.
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "io/mesh/mesh_format.hpp"
#include "tests/io/mesh/temporary_folder.hpp"

namespace quarry {

// Reading a file of that name and content ends in Error(kInput) with the message in it.
inline void expect_read_error(const std::string& name, const std::string& content,
                              const std::string& message) {
  const TemporaryFolder folder;
  try {
    static_cast<void>(read_mesh(folder.file(name, content)));
    ADD_FAILURE() << "no error that says: " << message;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    EXPECT_NE(error.message().find(message), std::string::npos) << error.message();
  }
}

inline ReadCells read_text_as(const std::string& name, const std::string& content) {
  const TemporaryFolder folder;
  return read_cells(folder.file(name, content));
}

}  // namespace quarry
