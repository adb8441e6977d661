#include "api/ask/history/series_limit.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "fields/base/advice.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "ingest/cf/units.h"
#include "ingest/history/offer.h"

namespace slackwater::api {
namespace {

using twin::BoundSide;

struct Sign {
  std::string_view text;
  BoundSide side;
};
constexpr Sign signs[] = {{"<=", BoundSide::at_most}, {">=", BoundSide::at_least},
                          {"≤", BoundSide::at_most},  {"≥", BoundSide::at_least},
                          {"<", BoundSide::below},    {">", BoundSide::above}};

const Sign* sign_at(std::string_view text, std::size_t at) {
  const auto* const found = std::find_if(std::begin(signs), std::end(signs), [&](const Sign& sign) {
    return text.substr(at).starts_with(sign.text);
  });
  return found == std::end(signs) ? nullptr : found;
}

/// The conversion from the unit of a limit; what does not convert is the limit's fault.
ingest::UnitConversion conversion(const SeriesLimit& limit, const std::string& from,
                                  const std::string& to, const std::string& of) {
  try {
    return ingest::unit_conversion(from, to, limit.text);
  } catch (const Error& problem) {
    if (problem.kind() != ErrorKind::invalid_input) throw;
    refuse("limit '" + limit.text + "': found the unit '" + from +
           "', which does not convert to '" + to + "', the unit of " + of);
  }
}

double rounded_to_twelve_digits(double value) {
  return std::strtod(formatted("{:.12g}", value).c_str(), nullptr);
}

double converted(const ingest::UnitConversion& unit, double value) {
  return unit.is_identity() ? value : rounded_to_twelve_digits(unit.scale * value + unit.offset);
}

bool is_upper(BoundSide side) { return side == BoundSide::at_most || side == BoundSide::below; }

/// Whether values exist that are within both: an upper bound and a lower one.
bool can_both_hold(const twin::Bound& upper, const twin::Bound& lower) {
  if (upper.value != lower.value) return lower.value < upper.value;
  return upper.side == BoundSide::at_most && lower.side == BoundSide::at_least;
}

}  // namespace

SeriesLimit parse_series_limit(const std::string& text) {
  SeriesLimit limit;
  limit.text = std::string(trimmed(text));
  const auto bad = [&](const std::string& why) {
    refuse("found the limit '" + text + "'" + why +
           "; expected NAME<=VALUE UNIT, e.g. 'sea_surface_wave_significant_height<=1.5 m'");
  };
  const Sign* sign = nullptr;
  std::size_t at = 0;
  for (; at < text.size() && sign == nullptr; ++at) sign = sign_at(text, at);
  if (sign == nullptr) bad(" without <=, <, >= or >");
  limit.bound.side = sign->side;
  limit.variable = std::string(trimmed(std::string_view(text).substr(0, at - 1)));
  std::string_view rest = trimmed(std::string_view(text).substr(at - 1 + sign->text.size()));
  if (rest.starts_with('+')) rest.remove_prefix(1);
  const auto [stop, problem] =
      std::from_chars(rest.data(), rest.data() + rest.size(), limit.bound.value);
  if (limit.variable.empty()) bad(" without a name");
  if (problem != std::errc{} || !std::isfinite(limit.bound.value)) bad(" without a finite number");
  limit.unit = std::string(trimmed(rest.substr(static_cast<std::size_t>(stop - rest.data()))));
  if (const auto meant = with_decimal_point(rest)) bad("; use a decimal point: " + *meant);
  return limit;
}

std::vector<std::string> expect_possible(const std::vector<SeriesLimit>& limits,
                                         const ingest::Vocabulary& vocabulary) {
  std::vector<std::string> idle;
  std::vector<std::pair<std::string, twin::Bound>> bounds;
  for (const SeriesLimit& limit : limits) {
    const ingest::Quantity* known = vocabulary.by_standard_name(limit.variable);
    twin::Bound bound = limit.bound;
    if (limit.table) bound.value = limit.table->greatest_m();
    if (known != nullptr) {
      if (!limit.unit.empty())
        bound.value = converted(conversion(limit, limit.unit, known->unit, known->standard_name),
                                bound.value);
      const Range& range = known->gross;
      const double easiest = is_upper(bound.side) ? range.low : range.high;
      const double hardest = is_upper(bound.side) ? range.high : range.low;
      if (!bound.holds(easiest))
        refuse("limit '" + limit.text + "' can never hold: " + known->standard_name +
               formatted(" lies between {:g} and {:g} {}", range.low, range.high, known->unit));
      if (bound.holds(hardest))
        idle.push_back("limit '" + limit.text + "' is never exceeded: " + known->standard_name +
                       formatted(" lies between {:g} and {:g} {}; is its unit right?", range.low,
                                 range.high, known->unit));
    }
    const std::string name = ingest::current_name(limit.variable, vocabulary);
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      const auto& [other, before] = bounds[i];
      if (other != name || is_upper(before.side) == is_upper(bound.side)) continue;
      if (known == nullptr && limits[i].unit != limit.unit) continue;
      const bool is_first = is_upper(bound.side);
      if (!can_both_hold(is_first ? bound : before, is_first ? before : bound))
        refuse("limits '" + limits[i].text + "' and '" + limit.text +
               "' can never hold together; correct one of them");
    }
    bounds.emplace_back(name, bound);
  }
  return idle;
}

std::string unit_of(const SeriesLimit& limit, const HistorySeries& series,
                    const ingest::Vocabulary& vocabulary) {
  if (!limit.unit.empty()) return limit.unit;
  const ingest::Quantity* known = vocabulary.by_standard_name(series.standard_name);
  return known != nullptr ? known->unit : series.unit;
}

twin::Bound bound_on(const SeriesLimit& limit, const HistorySeries& series,
                     const ingest::Vocabulary& vocabulary) {
  const ingest::UnitConversion unit =
      conversion(limit, unit_of(limit, series, vocabulary), series.unit,
                 "'" + series.name + "' in " + series.source);
  double value = converted(unit, limit.bound.value);
  if (series.is_single_precision) value = static_cast<float>(value);
  return {limit.bound.side, value};
}

}  // namespace slackwater::api
