#include "calibration/verify/what_came.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "calibration/day/given/surface_truth.h"
#include "fields/base/constants.h"
#include "fields/interpolate/column_levels.h"
#include "fields/record/choose.h"

namespace slackwater::calibration {
namespace {

constexpr Duration widest_gap = std::chrono::hours(3);

template <typename T>
Record<T> grids_of(const Record<T>& record) {
  Record<T> gridded;
  for (const auto& piece : record.pieces)
    if (!piece.origin->is_point_series) gridded.pieces.push_back(piece);
  return gridded;
}

/// Wind as it came: a moored instrument speaks where it has a value, else the analysed product.
class WindThatCame {
 public:
  WindThatCame(const VectorRecord& record, const Knowledge& known)
      : nearest_(surface_truth(record, known)), grids_(surface_truth(grids_of(record), known)) {}
  [[nodiscard]] std::optional<Horizontal> at(UtcTime time) const {
    const auto value = value_at(nearest_.column, time, widest_gap);
    return value ? value : value_at(grids_.column, time, widest_gap);
  }

 private:
  Chosen<Horizontal> nearest_;
  Chosen<Horizontal> grids_;
};

/// Waves as one voice has them: period and direction are of the run whose height it is.
class WavesAsAnalysed {
 public:
  WavesAsAnalysed(const ScalarRecord& height, const ScalarRecord& period,
                  const ScalarRecord& direction, const Knowledge& known)
      : height_(surface_truth(height, known)),
        period_(surface_truth(period, known, &height_.stretches)),
        direction_(surface_truth(direction, known, &height_.stretches)) {}

  /// The sea at a time, NaN for what nobody says; nothing without a height.
  [[nodiscard]] std::optional<SeaState> at(UtcTime time) const {
    const auto height_m = value_at(height_.column, time, widest_gap);
    if (!height_m) return std::nullopt;
    return SeaState{*height_m, value_at(period_.column, time, widest_gap).value_or(constants::nan),
                    from_direction_deg_at(time)};
  }

 private:
  /// Directions are not averaged: the later one speaks.
  [[nodiscard]] double from_direction_deg_at(UtcTime time) const {
    const ScalarColumn& column = direction_.column;
    for (std::size_t t = 0; t < column.times(); ++t) {
      const UtcTime centre = column.time[t].centre();
      if (centre < time || centre - time > widest_gap) continue;
      return column.has(t) ? column.value[t] : constants::nan;
    }
    return constants::nan;
  }

  Chosen<double> height_;
  Chosen<double> period_;
  Chosen<double> direction_;
};

/// The currents of one dataset as analysed, at the stamps and depths of the forecast.
VectorColumn currents_that_came(const ColumnData& data, const Snapshot& forecast,
                                const std::string& dataset, const Knowledge& known) {
  VectorRecord analysed;
  for (const auto& piece : data.current.pieces)
    if (piece.origin->status != DataStatus::forecast) analysed.pieces.push_back(piece);
  Choice choice;
  choice.dataset = dataset;
  std::vector<TimeCell> stamps;
  for (const UtcTime time : forecast.time) stamps.push_back(TimeCell::instant(time));
  const Chosen<Horizontal> chosen = choose(analysed, known, choice);
  if (chosen.empty()) return {};
  return at_times(at_depths(chosen.column, forecast.depth_m), stamps, widest_gap);
}

/// Sets the currents. @return how many stamps from the first on are known
std::size_t set_currents(const VectorColumn& came, const Snapshot& forecast,
                         const ForecastColumn& said, ForecastColumn& column) {
  const std::size_t levels = forecast.depth_m.size();
  for (std::size_t t = 0; t < forecast.time.size(); ++t)
    for (std::size_t k = 0; k < levels; ++k) {
      const std::size_t at = t * levels + k;
      if (said.current_status.empty() || !has_value(said.current_status[at])) continue;
      if (came.time.empty() || !came.has(t, k)) return t;
      column.current_m_s[at] = came.value[came.offset(t, k)];
    }
  return forecast.time.size();
}

std::size_t set_wind(const ColumnData& data, const Snapshot& forecast, const Knowledge& known,
                     ForecastColumn& column) {
  if (column.wind_m_s.empty()) return forecast.time.size();
  const WindThatCame came(data.wind, known);
  for (std::size_t t = 0; t < forecast.time.size(); ++t) {
    const auto value = came.at(forecast.time[t]);
    if (!value) return t;
    column.wind_m_s[t] = *value;
    column.wind_source[t] = DataStatus::analysis;
  }
  return forecast.time.size();
}

std::size_t set_waves(const ColumnData& data, const Snapshot& forecast, const Knowledge& known,
                      ForecastColumn& column) {
  const WavesAsAnalysed nearest(data.significant_height, data.peak_period, data.wave_direction,
                                known);
  const WavesAsAnalysed grids(grids_of(data.significant_height), grids_of(data.peak_period),
                              grids_of(data.wave_direction), known);
  for (std::size_t t = 0; t < column.sea.size(); ++t) {
    SeaState& sea = column.sea[t];
    if (std::isnan(sea.significant_height_m)) continue;
    auto came = nearest.at(forecast.time[t]);
    if (!came) came = grids.at(forecast.time[t]);
    if (!came) return t;
    sea.significant_height_m = came->significant_height_m;
    // What nobody analysed stays as it was forecast.
    if (!std::isnan(came->peak_period_s)) sea.peak_period_s = came->peak_period_s;
    if (!std::isnan(came->from_direction_deg)) sea.from_direction_deg = came->from_direction_deg;
    column.sea_source[t] = DataStatus::analysis;
  }
  return forecast.time.size();
}

/// The first `stamps` of an array that runs over all of them.
template <typename T>
void cut(std::vector<T>& values, std::size_t stamps, std::size_t all) {
  if (!values.empty()) values.resize(values.size() / all * stamps);
}

void cut(Snapshot& snapshot, std::size_t stamps) {
  const std::size_t all = snapshot.time.size();
  for (ForecastColumn& column : snapshot.columns) {
    cut(column.current_m_s, stamps, all);
    cut(column.current_sigma_m_s, stamps, all);
    cut(column.current_status, stamps, all);
    cut(column.wind_m_s, stamps, all);
    cut(column.wind_source, stamps, all);
    cut(column.sea, stamps, all);
    cut(column.sea_source, stamps, all);
    cut(column.height_spread, stamps, all);
    cut(column.sea_level.level_m, stamps, all);
    cut(column.sea_level.sigma_m, stamps, all);
    cut(column.sea_level.source, stamps, all);
  }
  snapshot.time.resize(stamps);
}

}  // namespace

std::shared_ptr<const Snapshot> what_came(const SiteData& data, const Snapshot& forecast,
                                          const std::string& dataset, UtcTime known_by) {
  Knowledge known;
  known.values_until = known_by;
  auto came = std::make_shared<Snapshot>(forecast);
  came->members = 1;
  std::size_t stamps = forecast.time.size();
  for (ForecastColumn& column : came->columns) {
    const ColumnData* of = data.column_at(column.point);
    if (of == nullptr) return nullptr;
    column.member_m_s.clear();
    column.wind_member_m_s.clear();
    column.wind_member_number.clear();
    std::fill(column.current_sigma_m_s.begin(), column.current_sigma_m_s.end(), 0.0);
    std::fill(column.height_spread.begin(), column.height_spread.end(), 0.0);
    std::fill(column.sea_level.sigma_m.begin(), column.sea_level.sigma_m.end(), 0.0);
    const std::size_t index = static_cast<std::size_t>(&column - came->columns.data());
    stamps =
        std::min({stamps,
                  set_currents(currents_that_came(*of, forecast, dataset, known), forecast,
                               forecast.columns[index], column),
                  set_wind(*of, forecast, known, column), set_waves(*of, forecast, known, column)});
  }
  if (stamps < 2) return nullptr;
  cut(*came, stamps);
  return came;
}

}  // namespace slackwater::calibration
