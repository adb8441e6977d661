#include "fields/service/wave_source.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace slackwater {
namespace {

constexpr std::size_t sources = 5;

/// Hours of each source, in the order of DataStatus.
using HoursOfSource = std::array<std::size_t, sources>;

HoursOfSource hours_of(const Snapshot& snapshot) {
  HoursOfSource hours{};
  for (const ForecastColumn& column : snapshot.columns) {
    for (std::size_t t = 0; t < std::min(column.sea.size(), column.sea_source.size()); ++t) {
      if (!std::isnan(column.sea[t].significant_height_m))
        ++hours[static_cast<std::size_t>(column.sea_source[t])];
    }
    if (std::any_of(hours.begin(), hours.end(), [](std::size_t n) { return n > 0; })) break;
  }
  return hours;
}

}  // namespace

std::string_view wave_source_words(DataStatus source) noexcept {
  static constexpr std::array<std::string_view, sources> words{
      "wave product, analysed", "wave product, forecast", "measured", "the last known sea, kept",
      "computed from the wind"};
  return words[static_cast<std::size_t>(source)];
}

std::optional<DataStatus> wave_source_at(const Snapshot& snapshot, UtcTime time) {
  if (snapshot.time.empty() || time < snapshot.time.front() || time > snapshot.time.back())
    return std::nullopt;
  const auto column = std::find_if(snapshot.columns.begin(), snapshot.columns.end(),
                                   [](const ForecastColumn& c) { return !c.sea_source.empty(); });
  if (column == snapshot.columns.end()) return std::nullopt;
  const auto after = std::lower_bound(snapshot.time.begin(), snapshot.time.end(), time);
  const auto high = static_cast<std::size_t>(after - snapshot.time.begin());
  const std::size_t low = *after == time ? high : high - 1;
  return std::max(column->sea_source.at(low), column->sea_source.at(high));
}

std::string wave_sources_text(const Snapshot& snapshot) {
  const HoursOfSource hours = hours_of(snapshot);
  const auto kinds = std::count_if(hours.begin(), hours.end(), [](std::size_t n) { return n > 0; });
  std::string text;
  for (std::size_t source = 0; source < sources; ++source) {
    if (hours[source] == 0) continue;
    const bool is_first = text.empty();
    text +=
        (is_first ? "" : ", ") + std::string(wave_source_words(static_cast<DataStatus>(source)));
    if (kinds == 1) continue;
    text += " (" + std::to_string(hours[source]);
    text += is_first ? " of " + std::to_string(snapshot.time.size()) + " hours)" : ")";
  }
  return text;
}

bool has_given_waves_only(const Snapshot& snapshot) noexcept {
  const HoursOfSource hours = hours_of(snapshot);
  return hours[static_cast<std::size_t>(DataStatus::persisted)] == 0 &&
         hours[static_cast<std::size_t>(DataStatus::modelled)] == 0;
}

}  // namespace slackwater
