#include "fields/base/log.h"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <algorithm>

namespace slackwater {
namespace {

spdlog::logger& logger() {
  static const std::shared_ptr<spdlog::logger> shared = [] {
    auto made = spdlog::stderr_logger_mt("slackwater");
    made->set_pattern("%Y-%m-%dT%H:%M:%S.%eZ %l %v", spdlog::pattern_time_type::utc);
    made->flush_on(spdlog::level::info);
    return made;
  }();
  return *shared;
}

std::string shown(std::string text) {
  bool wants_quotes = text.empty();
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 32 || c == 127) c = '.';
    if (c == '"') c = '\'';
    wants_quotes = wants_quotes || c == ' ' || c == '=';
  }
  return wants_quotes ? '"' + text + '"' : text;
}

}  // namespace

void log_event(LogLevel level, std::string_view event,
               std::initializer_list<std::pair<std::string_view, std::string>> values) {
  std::string line(event);
  for (const auto& [key, value] : values) line += ' ' + std::string(key) + '=' + shown(value);
  const auto as = level == LogLevel::error     ? spdlog::level::err
                  : level == LogLevel::warning ? spdlog::level::warn
                                               : spdlog::level::info;
  logger().log(as, line);
}

}  // namespace slackwater
