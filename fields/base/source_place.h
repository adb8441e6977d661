#pragma once
#include <source_location>

namespace slackwater {

#ifdef __cpp_lib_source_location
/// Where in the source an error was made.
using SourcePlace = std::source_location;
#else
/// Stands for std::source_location under clang 14 (fuzzing, clang-tidy), which lacks the builtin it
/// rests on.
class SourcePlace {
 public:
  static constexpr SourcePlace current(const char* file = __builtin_FILE(),
                                       const char* function = __builtin_FUNCTION(),
                                       unsigned line = __builtin_LINE()) noexcept {
    SourcePlace place;
    place.file_ = file;
    place.function_ = function;
    place.line_ = line;
    return place;
  }
  [[nodiscard]] constexpr const char* file_name() const noexcept { return file_; }
  [[nodiscard]] constexpr const char* function_name() const noexcept { return function_; }
  [[nodiscard]] constexpr unsigned line() const noexcept { return line_; }

 private:
  const char* file_ = "";
  const char* function_ = "";
  unsigned line_ = 0;
};
#endif

}  // namespace slackwater
