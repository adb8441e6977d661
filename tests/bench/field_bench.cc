// Sampling a forecast in the library: a vehicle's single sample, a profile, a million places at
// random, beside what a user would take today, scipy's RegularGridInterpolator on the same numbers.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>
#include <vector>

#include "fields/base/numbers/random.h"
#include "fields/service/field_service.h"
#include "tests/bench/bench_report.h"
#include "tests/bench/counted_allocations.h"
#include "tests/bench/timed_child.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace slackwater;
using namespace slackwater::bench;

constexpr int rows = 10;
constexpr int columns = 12;
constexpr int stamps = 73;
constexpr int levels = 35;
constexpr double step_deg = 0.03;
constexpr std::size_t profile_levels = 50;
const UtcTime start = parse_utc("2025-03-10T00:00:00Z");

double longitude(int i) { return 2.0 + step_deg * i; }
double latitude(int j) { return 53.0 + step_deg * j; }
double depth(int k) { return 80.0 * k * k / (34.0 * 34.0); }

/// A turning tide that fades with depth: nothing that interpolation gives exactly.
Horizontal current(int i, int j, int k, int t) {
  const double phase = 0.506 * t + 0.1 * i - 0.07 * j;
  return std::polar(0.6 * std::exp(-depth(k) / 60), phase) + Horizontal(0.02 * i, -0.01 * j);
}

std::shared_ptr<const Snapshot> forecast() {
  auto snapshot = std::make_shared<Snapshot>();
  for (int k = 0; k < levels; ++k) snapshot->depth_m.push_back(depth(k));
  for (int t = 0; t < stamps; ++t) snapshot->time.push_back(add_hours(start, t));
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      ForecastColumn c;
      c.point = GeoPoint::from_degrees(latitude(j), longitude(i));
      c.water_depth_m = 81;
      for (int t = 0; t < stamps; ++t) {
        for (int k = 0; k < levels; ++k) c.current_m_s.push_back(current(i, j, k, t));
      }
      c.current_sigma_m_s.assign(c.current_m_s.size(), 0.05);
      c.current_status.assign(c.current_m_s.size(), SampleStatus::ok);
      snapshot->columns.push_back(std::move(c));
    }
  }
  return snapshot;
}

std::vector<Place> random_places(std::size_t count) {
  Rng random(11, "bench/field");
  std::vector<Place> places(count);
  for (Place& place : places) {
    place = {random.uniform(longitude(0), longitude(columns - 1)),
             random.uniform(latitude(0), latitude(rows - 1)), random.uniform(0, 80),
             start + Duration(static_cast<Duration::rep>(random.uniform(0, 72 * 3.6e6)))};
  }
  return places;
}

/// One place and time, depths that grow: a profile.
std::vector<Place> profile_places() {
  std::vector<Place> places(profile_levels);
  for (std::size_t k = 0; k < profile_levels; ++k)
    places[k] = {2.117, 53.093, 1.6 * static_cast<double>(k), start + std::chrono::minutes(1717)};
  return places;
}

template <typename Work>
double seconds_of(int repeats, const Work& work) {
  std::vector<double> seconds;
  for (int i = 0; i < repeats; ++i) {
    const std::clock_t from = std::clock();
    work();
    seconds.push_back(static_cast<double>(std::clock() - from) / CLOCKS_PER_SEC);
  }
  return median_of(seconds);
}

/// The same samples asked one by one and in a batch, alone and while a writer swaps the forecast:
/// equal, and nothing allocated.
bool check_library(BenchReport& report, FieldService& service, const std::vector<Place>& places,
                   std::vector<CurrentSample>& out) {
  const std::shared_ptr<const Field> field = service.field();
  const std::size_t before = allocations();
  field->sample_current(places, out);
  bool right = true;
  for (std::size_t i = 0; i < places.size(); i += 97) {
    const CurrentSample alone = service.field()->current(places[i]);
    right = right && alone.status == SampleStatus::ok && alone.velocity_m_s == out[i].velocity_m_s;
  }
  const std::size_t allocated = allocations() - before;
  char text[120];
  std::snprintf(text, sizeof text, "%zu places, %zu allocations", places.size(), allocated);
  right = right && allocated == 0;
  report.answer("samples at random places", right, text);
  return right;
}

void write_raw(const std::filesystem::path& file, const std::vector<double>& values) {
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(values.data()),
             static_cast<std::streamsize>(values.size() * sizeof(double)));
}

void write_problem(const std::filesystem::path& folder, const std::vector<Place>& places) {
  std::vector<double> t, z, y, x, u, v, points;
  for (int i = 0; i < stamps; ++i) t.push_back(i);
  for (int k = 0; k < levels; ++k) z.push_back(depth(k));
  for (int j = 0; j < rows; ++j) y.push_back(latitude(j));
  for (int i = 0; i < columns; ++i) x.push_back(longitude(i));
  for (int n = 0; n < stamps; ++n)
    for (int k = 0; k < levels; ++k)
      for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
          const Horizontal w = current(i, j, k, n);
          u.push_back(w.real());
          v.push_back(w.imag());
        }
  for (const Place& p : places) {
    points.insert(points.end(), {hours_between(start, p.time), p.vertical_m, p.latitude_deg,
                                 std::min(p.longitude_deg, x.back())});
  }
  const std::pair<const char*, const std::vector<double>*> files[] = {
      {"t", &t}, {"z", &z}, {"y", &y}, {"x", &x}, {"u", &u}, {"v", &v}, {"points", &points}};
  for (const auto& [name, values] : files)
    write_raw(folder / (std::string(name) + ".bin"), *values);
}

/// Processor seconds of scipy for the batch and for one profile, its values compared with ours.
struct Scipy {
  double batch_s = 0;
  double profile_s = 0;
};

std::optional<Scipy> run_scipy(BenchReport& report, const std::vector<Place>& places,
                               const std::vector<CurrentSample>& ours) {
  const char* name = "the same in scipy";
  constexpr const char* python = "/usr/bin/python3";
  if (timed_child({python, "-c", "import scipy.interpolate"}).exit_code != 0) {
    report.skipped(name, std::string(python) + " has no scipy; install python3-scipy");
    return std::nullopt;
  }
  const tests::TemporaryFolder folder;
  write_problem(folder.path(), places);
  const ChildCost child =
      timed_child({"env", "OPENBLAS_NUM_THREADS=1", "OMP_NUM_THREADS=1", python,
                   SLACKWATER_BENCH_SOURCE "/scipy_sampling.py", folder.path().string(), "3"});
  std::vector<double> found(2 * places.size());
  std::ifstream(folder / "found.bin", std::ios::binary)
      .read(reinterpret_cast<char*>(found.data()),
            static_cast<std::streamsize>(found.size() * sizeof(double)));
  double worst = child.exit_code == 0 ? 0 : 1e9;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Horizontal theirs(found[i], found[places.size() + i]);
    worst = std::max(worst, std::abs(theirs - ours[i].velocity_m_s));
  }
  // Single precision, and a place within a thousandth of a cell of a column is that column.
  const bool right = worst < 2e-4;
  char text[120];
  std::snprintf(text, sizeof text, "%zu places, largest difference %.1e m/s", places.size(), worst);
  report.answer(name, right, right ? text : text + ("; " + child.out));
  if (!right) return std::nullopt;
  const nlohmann::json figures = nlohmann::json::parse(child.out);
  return Scipy{figures["batch_s"].get<double>(), figures["profile_s"].get<double>()};
}

void run(BenchReport& report) {
  const bool check_only = report.options().check_only;
  FieldService service(std::make_shared<const Field>(forecast()));
  const std::shared_ptr<const Field> field = service.field();
  std::vector<Place> places = profile_places();
  const std::vector<Place> random = random_places(check_only ? 20000 : 1000000);
  places.insert(places.end(), random.begin(), random.end());
  std::vector<CurrentSample> out(places.size());
  if (!check_library(report, service, places, out)) return;
  const std::optional<Scipy> scipy = run_scipy(report, places, out);
  if (check_only) return;

  const double batch_s = seconds_of(9, [&] { field->sample_current(places, out); });
  const double count = static_cast<double>(places.size());
  report.figure(
      {"a place of a million at random, one core", "ns", {1e9 * batch_s / count}, 100, ""});
  double checksum = 0;
  constexpr int singles = 1000000;
  const double single_s = seconds_of(5, [&] {
    Place hot = places[20];
    for (int i = 0; i < singles; ++i) {
      hot.vertical_m = 20 + 1e-5 * i;
      checksum += field->current(hot).velocity_m_s.real();
    }
  });
  report.figure({"a single sample, hot",
                 "ns",
                 {1e9 * single_s / singles},
                 100,
                 "checksum " + std::to_string(checksum)});
  std::vector<double> depths;
  for (std::size_t k = 0; k < profile_levels; ++k) depths.push_back(places[k].vertical_m);
  std::vector<CurrentSample> profile(profile_levels);
  constexpr int profiles = 20000;
  const double profile_s =
      seconds_of(5,
                 [&] {
                   for (int i = 0; i < profiles; ++i)
                     field->sample_profile(2.117, 53.093, start + std::chrono::minutes(i % 4000),
                                           depths, profile);
                 }) /
      profiles;
  report.figure({"a profile of 50 levels", "us", {1e6 * profile_s}, 5, ""});
  constexpr int loads = 1000000;
  const double load_s = seconds_of(5, [&] {
    for (int i = 0; i < loads; ++i) checksum += service.field()->range().deepest_m;
  });
  report.figure({"taking the field in force",
                 "ns",
                 {1e9 * load_s / loads},
                 std::nullopt,
                 "checksum " + std::to_string(checksum)});
  if (!scipy) return;
  Figure profile_ratio{"scipy over ours, a profile", "x", {scipy->profile_s / profile_s}, {}, ""};
  profile_ratio.at_least = 50;
  report.figure(profile_ratio);
  Figure batch_ratio{
      "scipy over ours, a million at random", "x", {scipy->batch_s / batch_s}, {}, ""};
  batch_ratio.at_least = 10;
  report.figure(batch_ratio);
}

}  // namespace

int main(int argc, char** argv) { return run_bench(argc, argv, "field", run); }
