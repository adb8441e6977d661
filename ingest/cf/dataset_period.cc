#include "ingest/cf/dataset_period.h"

#include <algorithm>
#include <cctype>

namespace slackwater::ingest {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// "PT1H-m" from its P on.
std::optional<DatasetPeriod> period_at(std::string_view text) {
  text.remove_prefix(1);
  const bool within_a_day = text.starts_with('T');
  if (within_a_day) text.remove_prefix(1);
  long count = 0;
  std::size_t digits = 0;
  while (digits < text.size() && digits < 3 && is_digit(text[digits]))
    count = 10 * count + (text[digits++] - '0');
  if (count < 1 || text.size() < digits + 3 || text[digits + 1] != '-') return std::nullopt;
  const char unit = text[digits];
  const char kind = text[digits + 2];
  if (kind != 'm' && kind != 'i') return std::nullopt;
  if (text.size() > digits + 3 && std::isalnum(static_cast<unsigned char>(text[digits + 3])) != 0)
    return std::nullopt;

  DatasetPeriod period{kind == 'm', {}, !within_a_day && unit == 'M'};
  if (period.is_month) return count == 1 ? std::optional(period) : std::nullopt;
  if (within_a_day && unit == 'H') {
    period.step = std::chrono::hours(count);
  } else if (within_a_day && unit == 'M') {
    period.step = std::chrono::minutes(count);
  } else if (!within_a_day && unit == 'D') {
    period.step = std::chrono::hours(24 * count);
  } else {
    return std::nullopt;
  }
  // Only what divides a day lies on a clock.
  const bool divides = Duration(std::chrono::hours(24)) % period.step == Duration::zero();
  return !period.is_mean || divides ? std::optional(period) : std::nullopt;
}

}  // namespace

std::optional<DatasetPeriod> period_in(std::string_view text) {
  for (const std::string_view start : {"cmems_mod_", "cmems_obs"}) {
    for (std::size_t at = text.find(start); at != std::string_view::npos;
         at = text.find(start, at + 1)) {
      const std::string_view name = text.substr(at, text.find_first_of(" \"'/,;?&", at) - at);
      for (std::size_t p = name.find("_P"); p != std::string_view::npos;
           p = name.find("_P", p + 1)) {
        if (const auto period = period_at(name.substr(p + 1))) return period;
      }
    }
  }
  return std::nullopt;
}

std::optional<DatasetPeriod> stated_period(const netcdf::File& file) {
  for (const netcdf::Attribute& attribute : file.attributes()) {
    const auto text = attribute.text();
    if (!text) continue;
    if (const auto period = period_in(*text)) return period;
  }
  return std::nullopt;
}

}  // namespace slackwater::ingest
