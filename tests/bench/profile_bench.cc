// `slackwater profile` from a warm store as a whole process, its answer compared with
// the field of the same forecast; and 50 levels evaluated inside the library, exact on a
// current that is linear in depth and time, without allocation.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>
#include <nlohmann/json.hpp>

#include "fields/service/field.h"
#include "ingest/cf/forecast/forecast_file.h"
#include "tests/bench/bench_report.h"
#include "tests/bench/counted_allocations.h"
#include "tests/bench/synthetic_store.h"
#include "tests/bench/timed_child.h"

namespace {

using namespace slackwater;
using namespace slackwater::bench;

constexpr int process_repeats = 20;
constexpr double process_target_ms = 50;
constexpr double library_target_us = 5;
constexpr int library_repeats = 100000;

// --- the command --------------------------------------------------------------------------------

/// The depths and velocities that `profile --json` printed; not a number where it gave none.
struct PrintedProfile {
  std::vector<double> depth_m;
  std::vector<Horizontal> velocity_m_s;
};

PrintedProfile parse(const std::string& text) {
  PrintedProfile profile;
  const auto document = nlohmann::json::parse(text);
  for (const auto& level : document.at("levels")) {
    profile.depth_m.push_back(level.at("depth_m").get<double>());
    const auto component = [&](const char* name) {
      return level.contains(name) ? level.at(name).at("value").get<double>() : std::nan("");
    };
    profile.velocity_m_s.emplace_back(component("eastward_sea_water_velocity"),
                                      component("northward_sea_water_velocity"));
  }
  return profile;
}

/// JSON prints the shortest decimals that read back as the same double: equal to the bit.
bool same_as_library(const PrintedProfile& printed, const Field& field, UtcTime time) {
  std::vector<CurrentSample> samples(printed.depth_m.size());
  const GeoPoint& point = field.snapshot().columns.front().point;
  field.sample_profile(point.longitude_deg(), point.latitude_deg(), time, printed.depth_m, samples);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!has_value(samples[i].status) || samples[i].velocity_m_s != printed.velocity_m_s[i]) {
      return false;
    }
  }
  return samples.size() >= 5;
}

void bench_command(BenchReport& report) {
  const SyntheticStore synthetic;
  const std::filesystem::path out = synthetic.file("forecast.nc");
  slackwater_or_throw(synthetic.forecast_arguments(synthetic.store(), out));
  const Field field(std::make_shared<const Snapshot>(ingest::read_forecast(out)));
  const UtcTime time = UtcTime(synthetic.day()) + std::chrono::minutes(24 * 60 + 617);
  const std::vector<std::string> command{"profile", "--json",
                                         "--store", synthetic.store().string(),
                                         "--site",  synthetic.site_file().string(),
                                         "--time",  format_utc(time)};
  const PrintedProfile first = parse(slackwater_or_throw(command).out);  // warms the store
  const bool right = same_as_library(first, field, time);
  report.answer("profile", right,
                std::to_string(first.depth_m.size()) + " levels " +
                    (right ? "equal to" : "DIFFER from") + " the field in memory");
  if (!right || report.options().check_only) return;
  std::vector<double> wall_ms;
  std::vector<double> cpu_ms;
  for (int i = 0; i < process_repeats; ++i) {
    const ChildCost cost = slackwater_or_throw(command);
    wall_ms.push_back(1e3 * cost.wall_s);
    cpu_ms.push_back(1e3 * cost.cpu_s);
  }
  report.figure(
      {"slackwater profile, whole process, warm store", "ms", wall_ms, process_target_ms, ""});
  report.figure({"  its processor time", "ms", cpu_ms, std::nullopt, ""});
}

// --- the library --------------------------------------------------------------------------------

/// A current that interpolation in depth and time must give back but for rounding.
Horizontal linear_current(double depth_m, double hours) {
  return {0.4 - 0.01 * depth_m + 0.02 * hours, -0.2 + 0.004 * depth_m - 0.003 * hours};
}

Snapshot linear_snapshot() {
  constexpr int stamps = 73;
  constexpr int levels = 35;
  const UtcTime start = parse_utc("2025-03-10T00:00:00Z");
  Snapshot snapshot;
  ForecastColumn column;
  column.water_depth_m = 90;
  for (int k = 0; k < levels; ++k) snapshot.depth_m.push_back(80.0 * k * k / (34.0 * 34.0));
  for (int t = 0; t < stamps; ++t) {
    snapshot.time.push_back(add_hours(start, t));
    for (const double depth : snapshot.depth_m) {
      column.current_m_s.push_back(linear_current(depth, t));
      column.current_sigma_m_s.push_back(0.05);
      column.current_status.push_back(SampleStatus::ok);
    }
  }
  snapshot.columns.push_back(std::move(column));
  return snapshot;
}

void bench_library(BenchReport& report) {
  constexpr std::size_t levels = 50;
  const Field field(std::make_shared<const Snapshot>(linear_snapshot()));
  const UtcTime start = field.range().from;
  std::vector<double> depths;
  for (std::size_t k = 0; k < levels; ++k) depths.push_back(1.6 * static_cast<double>(k));
  std::vector<CurrentSample> samples(levels);
  const int runs = report.options().check_only ? 1000 : library_repeats;
  // Minutes all over the 72 hours, in an order that caches cannot guess.
  const auto minute_of = [](int i) { return (i * 2657) % (72 * 60 + 1); };

  double worst = 0;
  double checksum = 0;
  const std::size_t allocated_before = allocations();
  for (int i = 0; i < runs; ++i) {
    const int minute = minute_of(i);
    field.sample_profile(0, 0, start + std::chrono::minutes(minute), depths, samples);
    for (std::size_t k = 0; k < levels; ++k) {
      const Horizontal error = samples[k].velocity_m_s - linear_current(depths[k], minute / 60.0);
      worst = std::max(worst, samples[k].status == SampleStatus::ok ? std::abs(error) : 1e9);
      checksum += samples[k].velocity_m_s.real() + 2 * samples[k].velocity_m_s.imag();
    }
  }
  const std::size_t allocated = allocations() - allocated_before;
  char text[200];
  std::snprintf(text, sizeof text,
                "%d profiles of %zu levels, worst error %.1e m/s, %zu allocations, checksum %.9g",
                runs, levels, worst, allocated, checksum);
  // Values up to 2 m/s in single precision, a few roundings each.
  const bool right = worst < 1e-6 && allocated == 0;
  report.answer("profile from a field", right, text);
  if (!right || report.options().check_only) return;

  std::vector<double> us(static_cast<std::size_t>(runs));
  for (int i = 0; i < runs; ++i) {
    const UtcTime time = start + std::chrono::minutes(minute_of(i));
    const auto from = std::chrono::steady_clock::now();
    field.sample_profile(0, 0, time, depths, samples);
    us[static_cast<std::size_t>(i)] =
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - from).count();
  }
  report.figure({"profile from a field, 50 levels", "us", us, library_target_us, ""});
}

}  // namespace

int main(int argc, char** argv) {
  BenchReport report(bench_options(argc, argv));
  try {
    bench_library(report);
    bench_command(report);
  } catch (const std::exception& problem) {
    report.answer("profile", false, problem.what());
  }
  return report.exit_code();
}
