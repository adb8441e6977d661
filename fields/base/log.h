#pragma once
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace slackwater {

enum class LogLevel { info, warning, error };

/// One line on standard error: time, level, the event, then key=value pairs with the unit in the
/// key. Only `ingest` and `api` log (CONTRIBUTING.md). Thread-safe.
///
///   2025-03-10T05:00:02.114Z info serving address=127.0.0.1 port=8080
///
/// Values are quoted where they hold blanks; control characters in them become '.'.
void log_event(LogLevel level, std::string_view event,
               std::initializer_list<std::pair<std::string_view, std::string>> values = {});

}  // namespace slackwater
