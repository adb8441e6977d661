#include "ingest/quality/spike.h"

#include <cmath>
#include <complex>
#include <vector>

#include "fields/base/check.h"
#include "fields/base/numbers/statistics.h"

namespace slackwater::ingest {
namespace {

constexpr double scales = 8.0;
constexpr double normal_consistency = 1.4826;  // median absolute deviation to standard deviation
constexpr std::size_t fewest_triples = 8;
constexpr int longest_gap_steps = 3;

using Value = std::complex<double>;

struct Triple {
  std::size_t sample;
  double departure;  // |V2 - (V1 + V3)/2|
  double step;       // |V3 - V1|/2
};

/// Positions in `present` of the spikes of the series (times, values) that hold only samples with
/// values.
std::vector<std::size_t> spikes_of(double threshold, const std::vector<UtcTime>& times,
                                   const std::vector<Value>& values) {
  if (times.size() < fewest_triples + 2) return {};
  std::vector<Duration> gaps;
  for (std::size_t i = 1; i < times.size(); ++i) gaps.push_back(times[i] - times[i - 1]);
  const Duration longest_gap = longest_gap_steps * upper_median(gaps);

  std::vector<Triple> triples;
  std::vector<double> departures;
  for (std::size_t i = 1; i + 1 < times.size(); ++i) {
    if (gaps[i - 1] > longest_gap || gaps[i] > longest_gap) continue;
    const double departure = std::abs(values[i] - 0.5 * (values[i - 1] + values[i + 1]));
    triples.push_back({i, departure, 0.5 * std::abs(values[i + 1] - values[i - 1])});
    departures.push_back(departure);
  }
  if (triples.size() < fewest_triples) return {};
  const double scale = normal_consistency * upper_median(std::move(departures));

  std::vector<std::size_t> found;
  for (const Triple& triple : triples) {
    if (triple.departure - triple.step > threshold && triple.departure > scales * scale) {
      found.push_back(triple.sample);
    }
  }
  return found;
}

}  // namespace

std::size_t test_spikes(double threshold, std::span<const UtcTime> times,
                        std::span<const float> values, std::span<SampleStatus> status) {
  expects(times.size() == values.size() && times.size() == status.size(),
          "one time and status for each value");
  std::vector<std::size_t> present;
  std::vector<UtcTime> present_times;
  std::vector<Value> present_values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!has_value(status[i])) continue;
    present.push_back(i);
    present_times.push_back(times[i]);
    present_values.emplace_back(values[i], 0.0);
  }
  const auto spikes = spikes_of(threshold, present_times, present_values);
  std::size_t marked = 0;
  for (const std::size_t i : spikes) {
    if (status[present[i]] != SampleStatus::not_checked) continue;
    status[present[i]] = SampleStatus::suspect;
    ++marked;
  }
  return marked;
}

std::size_t test_vector_spikes(double threshold, std::span<const UtcTime> times,
                               std::span<const float> east, std::span<const float> north,
                               std::span<SampleStatus> east_status,
                               std::span<SampleStatus> north_status) {
  expects(times.size() == east.size() && times.size() == north.size() &&
              times.size() == east_status.size() && times.size() == north_status.size(),
          "one time, two components and two statuses for each vector");
  std::vector<std::size_t> present;
  std::vector<UtcTime> present_times;
  std::vector<Value> present_values;
  for (std::size_t i = 0; i < east.size(); ++i) {
    if (!has_value(east_status[i]) || !has_value(north_status[i])) continue;
    present.push_back(i);
    present_times.push_back(times[i]);
    present_values.emplace_back(east[i], north[i]);
  }
  const auto spikes = spikes_of(threshold, present_times, present_values);
  std::size_t marked = 0;
  for (const std::size_t i : spikes) {
    SampleStatus& east_flag = east_status[present[i]];
    SampleStatus& north_flag = north_status[present[i]];
    if (east_flag != SampleStatus::not_checked && north_flag != SampleStatus::not_checked) continue;
    east_flag = north_flag = SampleStatus::suspect;
    ++marked;
  }
  return marked;
}

std::optional<double> spike_threshold_of(std::string_view name) noexcept {
  if (name == "eastward_sea_water_velocity" || name == "northward_sea_water_velocity" ||
      name == "sea_water_speed") {
    return 1.0;
  }
  if (name == "eastward_wind" || name == "northward_wind" || name == "wind_speed" ||
      name == "wind_speed_of_gust") {
    return 20.0;
  }
  if (name == "sea_surface_wave_significant_height") return 3.0;
  if (name == "sea_water_temperature") return 6.0;
  return std::nullopt;
}

}  // namespace slackwater::ingest
