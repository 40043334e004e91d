// Messages for people: one line each, to the standard error stream. Results never go through here.
#pragma once

#include <string_view>

#include <fmt/format.h>

namespace quarry::log {

enum class Level { kQuiet, kNormal, kVerbose };

void set_level(Level level);
void write_info(std::string_view line);
void write_warning(std::string_view line);
void write_detail(std::string_view line);
void write_error(std::string_view line);

template <class... Args>
void info(fmt::format_string<Args...> format, Args&&... args) {
  write_info(fmt::format(format, std::forward<Args>(args)...));
}
template <class... Args>
void warn(fmt::format_string<Args...> format, Args&&... args) {
  write_warning(fmt::format(format, std::forward<Args>(args)...));
}
// Shown with -v only.
template <class... Args>
void detail(fmt::format_string<Args...> format, Args&&... args) {
  write_detail(fmt::format(format, std::forward<Args>(args)...));
}

}  // namespace quarry::log
