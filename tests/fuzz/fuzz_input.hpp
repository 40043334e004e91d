// What the fuzz targets of readers have in common: bytes in, a file with them, and checks that end the run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <string>

#include <unistd.h>

namespace quarry::fuzz {

// The readers take paths: one file a process, in memory where the system has /dev/shm. The file goes with the
// process.
class InputFile {
 public:
  explicit InputFile(const std::string& extension)
      : path_((access("/dev/shm", W_OK) == 0 ? "/dev/shm" : "/tmp") +
              ("/quarry_fuzz_" + std::to_string(getpid())) + extension) {}
  ~InputFile() { unlink(path_.c_str()); }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::string& write(const std::uint8_t* data, std::size_t size) const {
    std::ofstream(path_, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    return path_;
  }

 private:
  std::string path_;
};

inline void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace quarry::fuzz
