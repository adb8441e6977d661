#include "api/door/edr/read/vertical.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "api/door/edr/read/bad_parameter.h"
#include "api/door/edr/read/number.h"
#include "api/door/edr/read/wkt.h"

namespace slackwater::api::edr {
namespace {

constexpr std::size_t max_z_bytes = std::size_t{32} * 1024;
constexpr std::string_view forms_of_level =
    "a level (10), a list (0,5,10), a range (0/50) or a sequence (R20/100/50: 20 levels from 100, "
    "50 "
    "apart), in metres";

double level_of(std::string_view text) {
  const auto level = number_of(text);
  if (!level) throw bad_parameter("z", text, forms_of_level);
  if (std::abs(*level) > max_vertical_m) {
    throw bad_parameter("z", text, "levels within 20000 m of mean sea level");
  }
  return *level;
}

Levels ascending(Levels levels) {
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

std::string_view take_until(char separator, std::string_view& rest) {
  const std::size_t end = std::min(rest.find(separator), rest.size());
  const std::string_view piece = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return piece;
}

[[noreturn]] void refuse_many(std::string_view text) {
  throw bad_parameter("z", text, "at most " + std::to_string(max_levels) + " levels");
}

Levels list_of(std::string_view text) {
  const auto commas = static_cast<std::size_t>(std::count(text.begin(), text.end(), ','));
  if (commas + 1 > max_levels) refuse_many(text);
  if (text.ends_with(',')) throw bad_parameter("z", text, forms_of_level);
  Levels levels;
  while (!text.empty()) levels.push_back(level_of(take_until(',', text)));
  return ascending(std::move(levels));
}

/// "20/100/50", what stands behind the R.
Levels sequence_of(std::string_view text) {
  const std::string_view whole = text;
  if (std::count(text.begin(), text.end(), '/') != 2)
    throw bad_parameter("z", whole, forms_of_level);
  const auto count = count_of(take_until('/', text));
  const double first = level_of(take_until('/', text));
  const double step = level_of(text);
  if (!count || *count == 0) throw bad_parameter("z", whole, forms_of_level);
  if (*count > max_levels) refuse_many(whole);
  if (step == 0 && *count > 1) throw bad_parameter("z", whole, "a step that is not 0");
  const double last = first + step * static_cast<double>(*count - 1);
  if (std::abs(last) > max_vertical_m) {
    throw bad_parameter("z", whole, "a sequence that stays within 20000 m of mean sea level");
  }
  Levels levels;
  for (std::size_t i = 0; i < *count; ++i) levels.push_back(first + step * static_cast<double>(i));
  return ascending(std::move(levels));
}

LevelRange range_of(std::string_view text) {
  const std::string_view whole = text;
  const double low = level_of(take_until('/', text));
  const double high = level_of(text);
  if (high < low) {
    throw bad_parameter("z", whole, "the smaller level first, as in 0/50");
  }
  return {low, high};
}

}  // namespace

VerticalQuery parse_vertical(std::string_view text) {
  static_assert(max_vertical_m == 20'000, "as the messages say");
  expect_short("z", text, max_z_bytes);
  if (text.empty()) throw bad_parameter("z", text, forms_of_level);
  if (text.starts_with('R') || text.starts_with('r')) return sequence_of(text.substr(1));
  if (text.find('/') != std::string_view::npos) return range_of(text);
  return list_of(text);
}

}  // namespace slackwater::api::edr
