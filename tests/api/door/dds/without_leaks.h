#pragma once
#include <cstdlib>
#include <map>
#include <string>

namespace slackwater::tests {

/// For a sanitized program on DDS: leaks of Fast DDS at its end are not ours to report.
/// @param besides  options of the sanitizer, each with a colon before it
[[nodiscard]] inline std::map<std::string, std::string> without_leaks(
    const std::string& besides = {}) {
  const char* asan = std::getenv("ASAN_OPTIONS");
  return {{"ASAN_OPTIONS", std::string(asan != nullptr ? asan : "") + ":detect_leaks=0" + besides}};
}

}  // namespace slackwater::tests
