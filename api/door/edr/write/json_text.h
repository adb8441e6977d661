#pragma once
#include <string>
#include <string_view>

#include "fields/base/time.h"

// JSON as text, appended to a string: answers hold thousands of numbers, which a tree of values
// would each allocate.

namespace slackwater::api::edr {

/// A string with its quotes. Control characters are escaped; bytes that are not UTF-8, which JSON
/// may not hold, become U+FFFD.
void append_string(std::string& out, std::string_view text);

/// A value with at most six significant digits, trailing zeros cut: "0.123457", "-12", "1e-07";
/// what is not finite is `null`. Off the value by at most half a unit of the sixth digit (and a
/// relative rounding error of 2^-52). About 15 ns for what lies between 1e-5 and 1e6.
void append_value(std::string& out, double value);

/// Degrees or metres with at most seven decimals (a centimetre on the globe); finite, below 1e8.
void append_coordinate(std::string& out, double value);

/// "2025-03-09T06:00:00Z" without quotes, as `format_utc` writes it, at a tenth of its cost.
void append_time(std::string& out, UtcTime time);

/// Puts a comma before every item of a list but the first.
class Separator {
 public:
  explicit Separator(std::string& out) noexcept : out_(out) {}
  void next() {
    if (!is_first_) out_ += ',';
    is_first_ = false;
  }

 private:
  std::string& out_;
  bool is_first_ = true;
};

}  // namespace slackwater::api::edr
