// Shapelib's file functions, with its messages kept instead of printed.
#pragma once

#include <string>

#include <shapefil.h>

namespace quarry {

// What went wrong last in this thread; "" if nothing did since it was cleared.
inline thread_local std::string shapelib_message;

[[nodiscard]] inline SAHooks make_shapelib_hooks() {
  shapelib_message.clear();
  SAHooks hooks{};
  SASetupDefaultHooks(&hooks);
  hooks.Error = [](const char* message) {
    shapelib_message = message;
    for (char& c : shapelib_message)
      if (c == '\n' || c == '\r') c = ' ';
  };
  return hooks;
}

}  // namespace quarry
