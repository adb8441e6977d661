#pragma once
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fields/record/site_data.h"

namespace slackwater::tests {

/// (east, north) at a time and depth; NaN: missing.
using FlowForTests = std::function<Horizontal(UtcTime, double)>;
using LevelForTests = std::function<double(UtcTime)>;

/// The same at all times and depths.
[[nodiscard]] FlowForTests steady(Horizontal value);

/// Where pieces come from: an analysis, a provider's forecast, a moored instrument.
[[nodiscard]] Origin analysis_of(const std::string& dataset, std::int64_t granule = 1);
[[nodiscard]] Origin forecast_of(const std::string& dataset, UtcTime issued,
                                 std::int64_t granule = 2);
/// The same of a file that came in then, and so was known however far it runs on.
[[nodiscard]] inline Origin received(Origin origin, UtcTime then) {
  origin.received = then;
  return origin;
}
[[nodiscard]] Origin station_of(const std::string& name, std::int64_t granule = 3);

/// Instants from the first to the last, both included, or means between them.
[[nodiscard]] std::vector<TimeCell> instants(UtcTime from, UtcTime to,
                                             Duration step = std::chrono::hours(1));
[[nodiscard]] std::vector<TimeCell> means(UtcTime from, UtcTime to,
                                          Duration step = std::chrono::hours(1));

/// A vector at these times; no depths: one level without a depth. The origin has to outlive it.
[[nodiscard]] PieceColumn<Horizontal> vector_piece(const Origin& origin,
                                                   const std::vector<TimeCell>& time,
                                                   const std::vector<double>& depth_m,
                                                   const FlowForTests& flow, double distance_m = 0);
[[nodiscard]] PieceColumn<double> scalar_piece(const Origin& origin,
                                               const std::vector<TimeCell>& time,
                                               const LevelForTests& level);

/// What is known at one place, built in memory. Owns the origins: it moves but does not copy, and
/// copies of `data` live as long as it does.
class KnownSeriesForTests {
 public:
  KnownSeriesForTests();
  KnownSeriesForTests(KnownSeriesForTests&&) = default;
  KnownSeriesForTests& operator=(KnownSeriesForTests&&) = default;

  void current(const Origin& origin, const std::vector<TimeCell>& time,
               const std::vector<double>& depth_m, const FlowForTests& flow, double distance_m = 0);
  void wind(const Origin& origin, const std::vector<TimeCell>& time, const FlowForTests& flow);
  void waves(const Origin& origin, const std::vector<TimeCell>& time, const LevelForTests& height_m,
             const LevelForTests& period_s, const LevelForTests& from_direction_deg);

  void sea_level(const Origin& origin, const std::vector<TimeCell>& time,
                 const LevelForTests& level_m);

  ColumnData data;  ///< at 54 N 6.5 E, 30 m deep

 private:
  const Origin& kept(const Origin& origin);
  std::deque<Origin> origins_;
};

/// A site of these columns.
[[nodiscard]] SiteData site_of(std::vector<ColumnData> columns);

/// Everything that nobody could know at `time` is made absurd: values that were analysed or
/// observed for later, and forecasts with a reference time after `issued_by`.
void spoil_after(ColumnData& data, UtcTime time, UtcTime issued_by);
/// Every value that holds after `time` is made absurd, that of forecasts too.
void spoil_all_after(ColumnData& data, UtcTime time);

/// The same problem seen with east and north turned.
void turn(VectorRecord& record, Horizontal by);

}  // namespace slackwater::tests
