#include "api/show/report/forecast_speed.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fields/base/constants.h"
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

ReportTable slack_table(const ReportSpeedAtDepth& at, double below_m_s, const PageClock& clock) {
  ReportTable table;
  table.title = "Slack at " + at.label + formatted(": likely speed below {:g} m/s", below_m_s);
  table.note =
      "Likely: the speed is as often lower as higher. Surely: it stays below in 9 of 10 cases. " +
      clock.note();
  table.columns = {"From", "To", "Lasts", "Surely from", "to"};
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

}  // namespace

bool has_currents(const Snapshot& forecast) {
  const std::vector<SampleStatus>& status = forecast.columns.front().current_status;
  return std::any_of(status.begin(), status.end(), [](SampleStatus s) { return has_value(s); });
}

ReportSpeed speed_of(const Field& field, double depth_m, double slack_below_m_s,
                     const PageClock& clock) {
  const Snapshot& s = field.snapshot();
  const ForecastColumn& column = s.columns.front();
  const std::vector<double> depths = offered_depths(column.water_depth_m, depth_m);
  ReportSpeed speed;
  speed.slack_below_m_s = slack_below_m_s;
  for (UtcTime time = s.time.front(); time <= s.time.back(); time += minutes(10))
    speed.time.push_back(time);
  std::vector<CurrentSample> samples(speed.time.size() * depths.size());
  field.sample_profiles(column.point.longitude_deg(), column.point.latitude_deg(), speed.time,
                        depths, samples);
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
    at.slack = slack_windows(speed.time, at.likely_m_s, at.high_m_s, slack_below_m_s);
    at.slack_table = slack_table(at, slack_below_m_s, clock);
    if (depths[k] == depth_m) speed.first = k;
    speed.depths.push_back(std::move(at));
  }
  return speed;
}

std::vector<StrongestStream> strongest_streams(const ReportSpeed& speed,
                                               const ReportSpeedAtDepth& at) {
  std::vector<StrongestStream> found;
  for (std::size_t i = 0; i < speed.time.size(); ++i) {
    const bool sees_both_sides = speed.time[i] - speed.time.front() >= hours(3) &&
                                 speed.time.back() - speed.time[i] >= hours(3);
    if (!sees_both_sides || std::isnan(at.likely_m_s[i])) continue;
    bool is_largest = true;
    for (std::size_t j = 0; j < speed.time.size() && is_largest; ++j) {
      const auto away = speed.time[j] - speed.time[i];
      if (away < -hours(3) || away > hours(3) || j == i) continue;
      // Of equals the first counts.
      is_largest =
          j < i ? at.likely_m_s[j] < at.likely_m_s[i] : !(at.likely_m_s[j] > at.likely_m_s[i]);
    }
    if (is_largest) found.push_back({i});
  }
  return found;
}

std::string speed_text(const ReportSpeedAtDepth& at, std::size_t index) {
  return formatted("{:.2f} m/s ({:.2f} to {:.2f})", at.likely_m_s[index], at.low_m_s[index],
                   at.high_m_s[index]);
}

}  // namespace slackwater::api
