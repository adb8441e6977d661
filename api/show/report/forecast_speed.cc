#include "api/show/report/forecast_speed.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/numbers/averaging.h"
#include "fields/base/text.h"
#include "fields/service/speed_quantiles.h"

namespace slackwater::api {
namespace {

using std::chrono::hours;
using std::chrono::minutes;

using constants::nan;

/// The depths on offer, the wanted one among them.
std::vector<double> offered_depths(double water_depth_m, double wanted_m) {
  constexpr std::array<double, 11> usual{0, 5, 10, 15, 20, 30, 50, 75, 100, 200, 500};
  std::vector<double> depths{wanted_m};
  for (const double depth_m : usual)
    if (depth_m < water_depth_m && depth_m != wanted_m) depths.push_back(depth_m);
  std::sort(depths.begin(), depths.end());
  return depths;
}

std::string duration_text(Duration duration) {
  const auto whole = std::chrono::round<minutes>(duration).count();
  return whole < 60 ? formatted("{} min", whole)
                    : formatted("{} h {:02} min", whole / 60, whole % 60);
}

ReportTable slack_table(const ReportSpeed& speed, const ReportSpeedAtDepth& at,
                        const PageClock& clock) {
  ReportTable table;
  table.title =
      "Slack at " + at.label + formatted(": likely speed below {:g} m/s", speed.slack_below_m_s);
  if (!speed.no_tide.empty()) {
    table.columns = {"Slack"};
    table.rows.push_back({speed.no_tide});
    return table;
  }
  table.note =
      "Likely: the speed is as often lower as higher. Nearly sure: it stays below all that time "
      "in 9 of 10 futures of the forecast. " +
      clock.note();
  table.columns = {"From", "To", "Lasts", "Nearly sure from", "to"};
  for (const SlackWindow& window : at.slack) {
    const bool is_cut = window.is_cut_before || window.is_cut_after;
    table.rows.push_back({(window.is_cut_before ? "before " : "") + clock.stamp(window.from),
                          (window.is_cut_after ? "after " : "") + clock.stamp(window.to),
                          (is_cut ? "more than " : "") + duration_text(window.to - window.from),
                          window.sure_from ? clock.stamp(*window.sure_from) : "never",
                          window.sure_to ? clock.stamp(*window.sure_to) : "never"});
  }
  if (table.rows.empty()) {
    table.rows.push_back({"never in this forecast", "", "", "", ""});
  }
  return table;
}

/// The speed in each future, by depth; none where the forecast has no members.
std::vector<std::vector<std::vector<double>>> futures_of(const Field& field, const GeoPoint& place,
                                                         const std::vector<UtcTime>& time,
                                                         const std::vector<double>& depths) {
  const Snapshot& s = field.snapshot();
  std::vector<std::vector<std::vector<double>>> futures(depths.size());
  if (s.columns.front().member_m_s.empty()) return futures;
  std::vector<CurrentSample> samples(time.size() * depths.size());
  for (std::size_t m = 0; m < s.members; ++m) {
    field.sample_profiles(place.longitude_deg(), place.latitude_deg(), time, depths, samples, m);
    for (std::size_t k = 0; k < depths.size(); ++k) {
      std::vector<double>& speeds = futures[k].emplace_back();
      for (std::size_t t = 0; t < time.size(); ++t) {
        const CurrentSample& sample = samples[t * depths.size() + k];
        speeds.push_back(has_value(sample.status) ? std::abs(sample.velocity_m_s) : nan);
      }
    }
  }
  return futures;
}

/// Why a forecast says nothing of slack; empty where it does.
std::string no_tide_in(const Snapshot& s) {
  if (!s.averaged) return {};
  return "not known: the currents are " + averaging_text(s.averaged->averaging) +
         ", which leave out the tide";
}

std::vector<UtcTime> every_ten_minutes(const Snapshot& s) {
  std::vector<UtcTime> times;
  for (UtcTime time = s.time.front(); time <= s.time.back(); time += minutes(10))
    times.push_back(time);
  return times;
}

}  // namespace

SlackAt slack_at(const Field& field, const GeoPoint& place, double depth_m, double below_m_s) {
  SlackAt slack;
  slack.no_tide = no_tide_in(field.snapshot());
  if (!slack.no_tide.empty()) return slack;
  const std::vector<UtcTime> time = every_ten_minutes(field.snapshot());
  const std::vector<double> depths{depth_m};
  std::vector<CurrentSample> samples(time.size());
  field.sample_profiles(place.longitude_deg(), place.latitude_deg(), time, depths, samples);
  std::vector<double> likely_m_s;
  for (const CurrentSample& sample : samples)
    likely_m_s.push_back(
        has_value(sample.status)
            ? speed_quantiles(std::abs(sample.velocity_m_s), sample.sigma_m_s).p50_m_s
            : nan);
  slack.windows =
      slack_windows(time, likely_m_s, futures_of(field, place, time, depths).front(), below_m_s);
  return slack;
}

ReportSpeed speed_of(const Field& field, double depth_m, double slack_below_m_s,
                     const PageClock& clock) {
  const Snapshot& s = field.snapshot();
  const ForecastColumn& column = s.columns.front();
  const std::vector<double> depths = offered_depths(column.water_depth_m, depth_m);
  ReportSpeed speed;
  speed.slack_below_m_s = slack_below_m_s;
  speed.no_tide = no_tide_in(s);
  speed.time = every_ten_minutes(s);
  std::vector<CurrentSample> samples(speed.time.size() * depths.size());
  field.sample_profiles(column.point.longitude_deg(), column.point.latitude_deg(), speed.time,
                        depths, samples);
  const auto futures = futures_of(field, column.point, speed.time, depths);
  for (std::size_t k = 0; k < depths.size(); ++k) {
    ReportSpeedAtDepth at;
    at.label = depths[k] == 0 ? "the surface" : formatted("{:g} m", depths[k]);
    for (std::size_t t = 0; t < speed.time.size(); ++t) {
      const CurrentSample& sample = samples[t * depths.size() + k];
      const bool there = has_value(sample.status);
      const SpeedQuantiles found =
          there ? speed_quantiles(std::abs(sample.velocity_m_s), sample.sigma_m_s)
                : SpeedQuantiles{nan, nan, nan};
      at.low_m_s.push_back(found.p10_m_s);
      at.likely_m_s.push_back(found.p50_m_s);
      at.high_m_s.push_back(found.p90_m_s);
      at.towards_deg.push_back(there ? to_direction_deg(sample.velocity_m_s) : nan);
    }
    if (speed.no_tide.empty())
      at.slack = slack_windows(speed.time, at.likely_m_s, futures[k], slack_below_m_s);
    at.slack_table = slack_table(speed, at, clock);
    if (depths[k] == depth_m) speed.first = k;
    speed.depths.push_back(std::move(at));
  }
  return speed;
}

std::vector<StrongestStream> strongest_streams(const ReportSpeed& speed,
                                               const ReportSpeedAtDepth& at) {
  /// A current that falls by less within three hours has no tide worth a time.
  constexpr double least_fall = 0.1;
  std::vector<StrongestStream> found;
  if (!speed.no_tide.empty()) return found;
  for (std::size_t i = 0; i < speed.time.size(); ++i) {
    const bool sees_both_sides = speed.time[i] - speed.time.front() >= hours(3) &&
                                 speed.time.back() - speed.time[i] >= hours(3);
    if (!sees_both_sides || std::isnan(at.likely_m_s[i])) continue;
    bool is_largest = true;
    double least_m_s = at.likely_m_s[i];
    for (std::size_t j = 0; j < speed.time.size() && is_largest; ++j) {
      const auto away = speed.time[j] - speed.time[i];
      if (away < -hours(3) || away > hours(3) || j == i) continue;
      // Of equals the first counts.
      is_largest =
          j < i ? at.likely_m_s[j] < at.likely_m_s[i] : !(at.likely_m_s[j] > at.likely_m_s[i]);
      least_m_s = std::fmin(least_m_s, at.likely_m_s[j]);
    }
    const bool falls = at.likely_m_s[i] - least_m_s >= least_fall * at.likely_m_s[i];
    if (is_largest && falls) found.push_back({i});
  }
  return found;
}

std::string speed_text(const ReportSpeedAtDepth& at, std::size_t index) {
  return formatted("{:.2f} m/s (8 in 10: {:.2f} to {:.2f})", at.likely_m_s[index],
                   at.low_m_s[index], at.high_m_s[index]);
}

}  // namespace slackwater::api
