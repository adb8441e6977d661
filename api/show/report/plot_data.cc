#include "api/show/report/plot_data.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "api/json/plot_json.h"
#include "fields/base/check.h"
#include "fields/base/constants.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

/// Mean over depth by trapezoids between the levels that have a value; NaN where none has.
std::vector<Horizontal> depth_means(const ReportProfile& profile,
                                    const std::vector<Horizontal>& current) {
  std::vector<Horizontal> means;
  const std::size_t levels = profile.depth_m.size();
  for (std::size_t t = 0; t < profile.time.size(); ++t) {
    Horizontal sum = 0;
    double thickness_m = 0;
    Horizontal lone{constants::nan, 0};
    for (std::size_t k = 0; k < levels; ++k) {
      const Horizontal here = current[t * levels + k];
      if (std::isnan(here.real())) continue;
      lone = here;
      if (k == 0 || std::isnan(current[t * levels + k - 1].real())) continue;
      const double step_m = profile.depth_m[k] - profile.depth_m[k - 1];
      sum += 0.5 * step_m * (here + current[t * levels + k - 1]);
      thickness_m += step_m;
    }
    means.push_back(thickness_m > 0 ? sum / thickness_m : lone);
  }
  return means;
}

json profile_json(const ReportProfile& profile) {
  const std::size_t size = profile.time.size() * profile.depth_m.size();
  expects(!profile.time.empty() && !profile.depth_m.empty() && profile.current_m_s.size() == size,
          "a profile has a current for every time and depth");
  expects(profile.sigma_m_s.empty() || profile.sigma_m_s.size() == size,
          "sigma has the profile's shape");
  expects(profile.truth_m_s.empty() || profile.truth_m_s.size() == size,
          "truth has the profile's shape");
  expects(std::is_sorted(profile.depth_m.begin(), profile.depth_m.end()), "depths ascend");
  json out = {{"time", times(profile.time)},
              {"depth", numbers(profile.depth_m)},
              {"bed", number(profile.water_depth_m)},
              {"current", vectors(profile.current_m_s)},
              {"mean", vectors(depth_means(profile, profile.current_m_s))},
              {"sigma", numbers(profile.sigma_m_s)}};
  if (!profile.truth_m_s.empty()) {
    out["truth"] = vectors(profile.truth_m_s);
    out["truthMean"] = vectors(depth_means(profile, profile.truth_m_s));
  }
  const UtcTime wanted = profile.hodograph_time.value_or(profile.time[profile.time.size() / 2]);
  const auto found = std::lower_bound(profile.time.begin(), profile.time.end(), wanted);
  out["first"] = std::min<std::size_t>(static_cast<std::size_t>(found - profile.time.begin()),
                                       profile.time.size() - 1);
  return out;
}

json series_json(const ReportSeries& series, std::size_t size) {
  json lines = json::array();
  for (const ReportLine& line : series.lines) {
    expects(line.values.size() == size, "a line has a value for every time");
    expects(line.low.size() == line.high.size() && (line.low.empty() || line.low.size() == size),
            "a band has both edges for every time");
    lines.push_back({{"name", line.name},
                     {"values", numbers(line.values)},
                     {"low", numbers(line.low)},
                     {"high", numbers(line.high)},
                     {"truth", line.is_truth}});
  }
  expects(series.towards_deg.empty() || series.towards_deg.size() == size,
          "one arrow for every time");
  return {{"title", series.title},
          {"axis", series.axis},
          {"lines", lines},
          {"towards", numbers(series.towards_deg)}};
}

json speed_json(const ReportSpeed& speed) {
  expects(speed.first < speed.depths.size(), "the depth that is shown first is one of the depths");
  json depths = json::array();
  for (const ReportSpeedAtDepth& at : speed.depths) {
    const std::size_t size = speed.time.size();
    expects(at.low_m_s.size() == size && at.likely_m_s.size() == size &&
                at.high_m_s.size() == size && at.towards_deg.size() == size,
            "a speed with its band for every time");
    json slack = json::array();
    for (const SlackWindow& window : at.slack)
      slack.push_back(
          {window.from.time_since_epoch().count(), window.to.time_since_epoch().count()});
    depths.push_back({{"label", at.label},
                      {"low", numbers(at.low_m_s)},
                      {"likely", numbers(at.likely_m_s)},
                      {"high", numbers(at.high_m_s)},
                      {"towards", numbers(at.towards_deg)},
                      {"slack", slack},
                      {"title", at.slack_table.title},
                      {"rows", at.slack_table.rows}});
  }
  return {{"time", times(speed.time)},
          {"depths", depths},
          {"first", speed.first},
          {"below", number(speed.slack_below_m_s)}};
}

}  // namespace

std::string plot_data_json(const ReportInput& input) {
  json out = json::object();
  if (input.issued) out["issued"] = input.issued->time_since_epoch().count();
  if (!input.time_zone.empty()) {
    json changes = json::array();
    for (const ClockChange& change : input.clock_changes)
      changes.push_back({change.at.time_since_epoch().count(), change.offset.count(), change.name});
    out["local"] = {{"zone", input.time_zone}, {"changes", changes}};
  }
  if (input.speed) out["speed"] = speed_json(*input.speed);
  if (input.profile) out["profile"] = profile_json(*input.profile);
  if (!input.skill.empty()) {
    json rows = json::array();
    for (const ReportSkill& row : input.skill) {
      json entry = {{"method", row.method}, {"lead", row.lead}, {"rmse", number(row.rmse_m_s)}};
      if (row.interval_95_m_s) {
        entry["low"] = number(row.interval_95_m_s->first);
        entry["high"] = number(row.interval_95_m_s->second);
      }
      rows.push_back(entry);
    }
    out["skill"] = rows;
  }
  if (!input.series.empty()) {
    json panels = json::array();
    for (const ReportSeries& series : input.series) {
      panels.push_back(series_json(series, input.series_time.size()));
    }
    out["series"] = {{"time", times(input.series_time)}, {"panels", panels}};
  }
  return script_safe(out);
}

}  // namespace slackwater::api
