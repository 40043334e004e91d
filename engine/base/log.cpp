#include "engine/base/log.hpp"

#include <memory>

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

namespace quarry::log {
namespace {

spdlog::logger& logger() {
  static const std::shared_ptr<spdlog::logger> instance = [] {
    auto made = std::make_shared<spdlog::logger>("quarry", std::make_shared<spdlog::sinks::stderr_sink_mt>());
    made->set_pattern("quarry: %v");
    return made;
  }();
  return *instance;
}

}  // namespace

void set_level(Level level) {
  switch (level) {
    case Level::kQuiet:
      logger().set_level(spdlog::level::err);
      break;
    case Level::kNormal:
      logger().set_level(spdlog::level::info);
      break;
    case Level::kVerbose:
      logger().set_level(spdlog::level::debug);
      break;
  }
}

void write_info(std::string_view line) { logger().info(line); }
void write_warning(std::string_view line) { logger().warn("warning: {}", line); }
void write_detail(std::string_view line) { logger().debug(line); }
void write_error(std::string_view line) { logger().error("error: {}", line); }

}  // namespace quarry::log
