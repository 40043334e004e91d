// What improve promises of any mesh, in the plane or in space.
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "engine/parallel/parallel.hpp"
#include "io/mesh/mesh_format.hpp"
#include "pipeline/improve/improve.hpp"
#include "tests/io/mesh/temporary_folder.hpp"

namespace quarry {

// The file that is written has the same bytes on any number of threads, of which more than one take part.
inline void expect_same_bytes_on_threads(const TemporaryFolder& folder, const std::string& input) {
  const std::string output = folder.file("out.vtu");
  const auto bytes = [&] {
    write_mesh(output, improve_mesh({.input = input}, {}).mesh, {});
    return file_content(output);
  };
  std::string one;
  parallel::with_threads(1, [&] { one = bytes(); });
  for (const int threads : {2, 4, 7}) {
    const parallel::ParticipationProbe probe(3);
    parallel::with_threads(threads, [&] { EXPECT_TRUE(bytes() == one) << threads << " threads"; });
    EXPECT_GT(probe.chunks_of_other_threads(), 0U) << threads << " threads";
  }
}

// One line that begins with the file and holds the message.
inline void expect_improve_error(const ImproveOptions& options, ErrorKind kind, const std::string& message) {
  try {
    static_cast<void>(improve_mesh(options, {}));
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind) << error.message();
    EXPECT_NE(error.message().find(message), std::string::npos) << error.message();
    EXPECT_EQ(error.message().find(options.input), 0U) << error.message();
  }
}

}  // namespace quarry
