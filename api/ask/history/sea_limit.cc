#include "api/ask/history/sea_limit.h"

#include <algorithm>
#include <cmath>

#include "fields/base/config.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "ingest/cf/units.h"
#include "twin/mission/limit.h"

namespace slackwater::api {
namespace {

constexpr const char* height_name = "sea_surface_wave_significant_height";
constexpr const char* period_name = "sea_surface_wave_period_at_variance_spectral_density_maximum";
constexpr const char* direction_name = "sea_surface_wave_from_direction";

}  // namespace

bool is_limit_file(const std::string& text) {
  return trimmed(text).ends_with(".yaml") && text.find_first_of("<>=") == std::string::npos;
}

SeriesLimit read_series_limit(const std::string& text, const std::filesystem::path& folder) {
  if (!is_limit_file(text)) return parse_series_limit(text);
  const std::string name(trimmed(text));
  const Config config = Config::load(folder / name);
  const std::vector<twin::Limit> limits = twin::read_limits(config);
  config.expect_all_read();
  if (limits.size() != 1 || !limits.front().table)
    config.refuse("limits",
                  "expected one limit, significant_wave_height_m with a table by peak_period_s or "
                  "by rows of from_bow_deg; write one bound as '" +
                      std::string(height_name) + "<=1.5'");
  const twin::Limit& read = limits.front();
  SeriesLimit limit;
  limit.text = std::filesystem::path(name).filename().string() + ": " + twin::text_of(read);
  limit.variable = height_name;
  limit.bound = {twin::BoundSide::at_most, read.bound};
  limit.unit = "m";
  limit.table = read.table;
  return limit;
}

std::vector<std::string> sea_variables_of(const SeriesLimit& limit) {
  std::vector<std::string> names;
  if (!limit.table) return names;
  if (!limit.table->peak_period_s.empty()) names.emplace_back(period_name);
  if (!limit.table->off_bow_rad.empty() && limit.table->heading_rad)
    names.emplace_back(direction_name);
  return names;
}

std::string unknown_sea_of(const SeriesLimit& limit, const History& history) {
  if (!limit.table) return "";
  std::vector<std::string> unknown;
  for (const std::string& name : sea_variables_of(limit))
    if (!place_of(name, history))
      unknown.push_back("found no " + name + ": the worst of all " +
                        (name == period_name ? "periods" : "headings") + " counts");
  if (limit.table->goes_by_heading())
    unknown.emplace_back("found no heading_deg of the bow: the worst of all headings counts");
  return unknown.empty() ? "" : "limit '" + limit.text + "': " + joined(unknown, "; ");
}

std::vector<double> shares_of(const SeriesLimit& limit, const History& history) {
  const std::size_t height = *place_of(limit.variable, history);
  const HistorySeries& series = history.series[height];
  const auto conversion =
      ingest::unit_conversion("m", series.unit, "'" + series.name + "' in " + series.source);
  const std::vector<double> period_s = values_in("s", period_name, history);
  const std::vector<double> from_deg = values_in("degree", direction_name, history);
  std::vector<double> shares = history.regular.values[height];
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const SeaState sea{0, period_s.empty() ? constants::nan : period_s[i],
                       from_deg.empty() ? constants::nan : from_deg[i]};
    // As of one number, the bound is brought to the values, not the other way round.
    double bound = limit.table->limit_at(sea, constants::nan).at_most_m;
    if (!conversion.is_identity()) bound = conversion.scale * bound + conversion.offset;
    if (series.is_single_precision) bound = static_cast<float>(bound);
    shares[i] /= bound;
  }
  return shares;
}

}  // namespace slackwater::api
