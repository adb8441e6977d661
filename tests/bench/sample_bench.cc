// `slackwater sample` of a stored forecast on a grid of columns beside what a user would take
// today, `cdo remapbil` of the same numbers: whole process against whole process, a thousand points
// x 24 hours x 50 levels, both components.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "data/store/store.h"
#include "fields/base/numbers/random.h"
#include "ingest/cf/forecast/forecast_file.h"
#include "ingest/netcdf/file.h"
#include "tests/bench/bench_report.h"
#include "tests/bench/timed_child.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace slackwater;
using namespace slackwater::bench;
using ingest::netcdf::File;
using ingest::netcdf::Type;
using ingest::netcdf::Writer;

constexpr int rows = 10;
constexpr int columns = 12;
constexpr int stamps = 73;  // a forecast of three days, of which one is asked
constexpr int hours = 24;
constexpr int levels = 50;
constexpr int points = 1000;
constexpr double step_deg = 0.03;
constexpr double target_ratio = 20;
constexpr int repeats = 11;
const UtcTime start = parse_utc("2025-03-10T00:00:00Z");

double longitude(int i) { return 2.0 + step_deg * i; }
double latitude(int j) { return 53.0 + step_deg * j; }
double depth(int k) { return 80.0 * k / (levels - 1); }

/// A turning tide that fades with depth: nothing that interpolation gives exactly. As a product
/// keeps it, in float.
Horizontal current(int i, int j, int k, int t) {
  const double phase = 0.506 * t + 0.1 * i - 0.07 * j;
  const Horizontal w =
      std::polar(0.6 * std::exp(-depth(k) / 60), phase) + Horizontal(0.02 * i, -0.01 * j);
  return {static_cast<double>(static_cast<float>(w.real())),
          static_cast<double>(static_cast<float>(w.imag()))};
}

Snapshot forecast() {
  Snapshot s;
  s.site_id = "bench";
  s.site_name = "Benchmark";
  s.day = parse_day("2025-03-09");
  s.issued = parse_utc("2025-03-10T05:00:00Z");
  s.wind_policy = WindPolicy::best;
  s.headline = "made up";
  for (int k = 0; k < levels; ++k) s.depth_m.push_back(depth(k));
  for (int t = 0; t < stamps; ++t) s.time.push_back(add_hours(start, t));
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
      s.columns.push_back(std::move(c));
    }
  }
  return s;
}

class Problem {
 public:
  Problem() {
    std::ofstream(file("bench.yaml")) << "id: bench\nname: Benchmark\nlatitude_deg: 53.1\n"
                                         "longitude_deg: 2.1\nwater_depth_m: 81\n";
    store_forecast();
    write_points();
    write_grid();
  }

  [[nodiscard]] std::string file(const std::string& name) const {
    return (folder_ / name).string();
  }
  [[nodiscard]] std::vector<std::string> ours(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> command{"sample",
                                     "--store",
                                     file("store"),
                                     "--site",
                                     file("bench.yaml"),
                                     "--from",
                                     "2025-03-10T00:00:00Z",
                                     "--to",
                                     "2025-03-10T23:00:00Z",
                                     "--points",
                                     file("points.csv"),
                                     "--out",
                                     file("ours.nc")};
    command.insert(command.end(), more.begin(), more.end());
    return command;
  }
  [[nodiscard]] std::vector<std::string> theirs(const std::string& format) const {
    return {"cdo",
            "-s",
            "-O",
            "-f",
            format,
            "remapbil," + file("points.grid"),
            file("grid.nc"),
            file("theirs.nc")};
  }
  [[nodiscard]] const std::vector<GeoPoint>& places() const { return place_; }

 private:
  void store_forecast() const {
    store::Store store = store::Store::open(file("store"), store::OpenMode::create_or_write);
    const Snapshot made = forecast();
    store::ForecastRow row;
    row.site_id = made.site_id;
    row.day = made.day;
    row.issued = made.issued;
    row.valid_from = made.time.front();
    row.valid_to = made.time.back();
    row.wind_policy = made.wind_policy.value();
    row.summary_json = "{}";
    row.code_version = "bench";
    const auto content = store.staging_folder() / "forecast.nc";
    ingest::write_forecast(content, made);
    store.commit_forecast(row, content);
  }

  /// The same places for both, to the last digit that both read.
  void write_points() {
    Rng random(7, "bench/sample");
    std::ofstream csv(file("points.csv"));
    std::ofstream grid(file("points.grid"));
    csv << "latitude_deg,longitude_deg\n";
    std::string x;
    std::string y;
    for (int n = 0; n < points; ++n) {
      char text[2][32];
      std::snprintf(text[0], sizeof text[0], "%.6f",
                    random.uniform(latitude(0), latitude(rows - 1)));
      std::snprintf(text[1], sizeof text[1], "%.6f",
                    random.uniform(longitude(0), longitude(columns - 1)));
      csv << text[0] << ',' << text[1] << '\n';
      y += std::string(" ") + text[0];
      x += std::string(" ") + text[1];
      place_.push_back(GeoPoint::from_degrees(std::stod(text[0]), std::stod(text[1])));
    }
    grid << "gridtype = unstructured\ngridsize = " << points << "\nxvals =" << x << "\nyvals =" << y
         << '\n';
  }

  /// The day of the forecast that is asked, as a product file.
  void write_grid() const {
    Writer out = Writer::create(file("grid.nc"));
    const int t = out.unlimited_dimension("time");
    const int z = out.dimension("depth", levels);
    const int y = out.dimension("latitude", rows);
    const int x = out.dimension("longitude", columns);
    const auto axis = [&](const char* name, int dimension, const char* units) {
      Writer::Layout layout;
      if (dimension == t) layout.chunks = {hours};
      const int id = out.variable(name, Type::float64, {dimension}, layout);
      out.attribute(id, "standard_name", name);
      out.attribute(id, "units", units);
      return id;
    };
    const int t_id = axis("time", t, "seconds since 1970-01-01 00:00:00");
    const int z_id = axis("depth", z, "m");
    const int y_id = axis("latitude", y, "degrees_north");
    const int x_id = axis("longitude", x, "degrees_east");
    out.attribute(z_id, "positive", "down");
    const auto component = [&](const char* name) {
      Writer::Layout layout;
      layout.chunks = {1, levels, rows, columns};
      const int id = out.variable(name, Type::float32, {t, z, y, x}, layout);
      out.attribute(id, "units", "m s-1");
      return id;
    };
    const int u_id = component("uo");
    const int v_id = component("vo");
    out.attribute(Writer::global, "Conventions", "CF-1.8");
    out.end_definitions();
    std::vector<double> times, depths, north, east;
    std::vector<float> u, v;
    for (int n = 0; n < hours; ++n) times.push_back(seconds_between({}, add_hours(start, n)));
    for (int k = 0; k < levels; ++k) depths.push_back(depth(k));
    for (int j = 0; j < rows; ++j) north.push_back(latitude(j));
    for (int i = 0; i < columns; ++i) east.push_back(longitude(i));
    for (int n = 0; n < hours; ++n)
      for (int k = 0; k < levels; ++k)
        for (int j = 0; j < rows; ++j)
          for (int i = 0; i < columns; ++i) {
            u.push_back(static_cast<float>(current(i, j, k, n).real()));
            v.push_back(static_cast<float>(current(i, j, k, n).imag()));
          }
    out.write(t_id, std::vector<std::size_t>{0}, std::vector<std::size_t>{hours}, times);
    out.write_all(z_id, depths);
    out.write_all(y_id, north);
    out.write_all(x_id, east);
    const std::vector<std::size_t> from(4, 0);
    const std::vector<std::size_t> count{hours, levels, rows, columns};
    out.write(u_id, from, count, u);
    out.write(v_id, from, count, v);
    out.close();
  }

  tests::TemporaryFolder folder_;
  std::vector<GeoPoint> place_;
};

/// Bilinear in longitude and latitude, in doubles: what both ought to say.
Horizontal bilinear(const GeoPoint& point, int k, int t) {
  const double x = (point.longitude_deg() - longitude(0)) / step_deg;
  const double y = (point.latitude_deg() - latitude(0)) / step_deg;
  const int i = std::min(static_cast<int>(x), columns - 2);
  const int j = std::min(static_cast<int>(y), rows - 2);
  const double a = x - i;
  const double b = y - j;
  return (1 - b) * ((1 - a) * current(i, j, k, t) + a * current(i + 1, j, k, t)) +
         b * ((1 - a) * current(i, j + 1, k, t) + a * current(i + 1, j + 1, k, t));
}

struct Found {
  std::vector<double> u;
  std::vector<double> v;
};

Found read(const std::string& file, const char* u, const char* v) {
  const File in = File::open(file);
  if (in.find(u) == nullptr || in.find(v) == nullptr)
    throw std::runtime_error("found no " + std::string(u) + " in " + file);
  Found found{in.read_all(*in.find(u)), in.read_all(*in.find(v))};
  if (found.u.size() != std::size_t{points} * hours * levels || found.v.size() != found.u.size())
    throw std::runtime_error(file + " has an unexpected size");
  return found;
}

/// Every value of both against the exact one and against each other.
bool check_answers(BenchReport& report, const Problem& problem, bool with_cdo) {
  const Found ours =
      read(problem.file("ours.nc"), "eastward_sea_water_velocity", "northward_sea_water_velocity");
  const Found theirs = with_cdo ? read(problem.file("theirs.nc"), "uo", "vo") : Found{};
  double from_exact = 0;
  double from_cdo = 0;
  for (std::size_t n = 0; n < points; ++n) {
    for (std::size_t t = 0; t < hours; ++t) {
      for (std::size_t k = 0; k < levels; ++k) {
        const std::size_t o = (n * hours + t) * levels + k;   // point, time, depth
        const std::size_t c = (t * levels + k) * points + n;  // time, depth, point
        const Horizontal w(ours.u[o], ours.v[o]);
        const Horizontal exact =
            bilinear(problem.places()[n], static_cast<int>(k), static_cast<int>(t));
        from_exact = std::max(from_exact, std::abs(w - exact));
        if (with_cdo)
          from_cdo = std::max(from_cdo, std::abs(w - Horizontal(theirs.u[c], theirs.v[c])));
      }
    }
  }
  // Single precision of values up to 1 m/s and of weights; a place within a thousandth of a cell of
  // a column is that column (0.1 rad of phase a cell). cdo interpolates in single precision too.
  const bool right = from_exact < 1e-4 && from_cdo < 2e-4;
  char text[160];
  std::snprintf(text, sizeof text,
                "%d points x %d hours x %d levels, largest difference from bilinear %.1e m/s, from "
                "cdo %.1e m/s",
                points, hours, levels, from_exact, from_cdo);
  report.answer("sample", right, text);
  return right;
}

/// One run into a file that is not there yet: to replace one costs a flush of the disk, whoever
/// does it.
ChildCost fresh(const Problem& problem, const char* out, const std::vector<std::string>& command) {
  std::filesystem::remove(problem.file(out));
  const ChildCost cost = timed_child(command);
  if (cost.exit_code != 0) throw std::runtime_error(command.front() + " failed: " + cost.out);
  return cost;
}

/// Wall times of both, taken in turns, so that what else the machine does falls on both.
void measure(BenchReport& report, const Problem& problem) {
  std::vector<std::string> command = problem.ours();
  command.insert(command.begin(), tests::program_path().string());
  std::vector<double> ours_ms, ours_cpu_ms, start_ms, nc_ms, nc_cpu_ms, nc4_ms, ratio;
  for (int i = 0; i < repeats; ++i) {
    const ChildCost ours = fresh(problem, "ours.nc", command);
    const ChildCost nc = fresh(problem, "theirs.nc", problem.theirs("nc"));
    const ChildCost nc4 = fresh(problem, "theirs.nc", problem.theirs("nc4"));
    ours_ms.push_back(1e3 * ours.wall_s);
    ours_cpu_ms.push_back(1e3 * ours.cpu_s);
    start_ms.push_back(1e3 * slackwater_or_throw({"--version"}).wall_s);
    nc_ms.push_back(1e3 * nc.wall_s);
    nc_cpu_ms.push_back(1e3 * nc.cpu_s);
    nc4_ms.push_back(1e3 * nc4.wall_s);
    ratio.push_back(std::min(nc.wall_s, nc4.wall_s) / ours.wall_s);
  }
  report.figure({"slackwater sample, whole process", "ms", ours_ms, {}, ""});
  report.figure({"  its processor time", "ms", ours_cpu_ms, {}, ""});
  report.figure({"  of which starting and ending a process", "ms", start_ms, {}, ""});
  report.figure({"cdo remapbil to NetCDF classic, whole process", "ms", nc_ms, {}, ""});
  report.figure({"  its processor time", "ms", nc_cpu_ms, {}, ""});
  report.figure({"cdo remapbil to NetCDF-4, whole process", "ms", nc4_ms, {}, ""});
  Figure figure{"cdo (the faster) over ours", "x", ratio, {}, ""};
  figure.at_least = target_ratio;
  report.figure(figure);
}

void run(BenchReport& report) {
  const Problem problem;
  slackwater_or_throw(problem.ours());
  const bool has_cdo = timed_child({"cdo", "--version"}).exit_code == 0;
  if (!has_cdo) report.skipped("cdo remapbil", "found no cdo on the PATH; install cdo");
  if (has_cdo) {
    const ChildCost cost = timed_child(problem.theirs("nc4"));
    if (cost.exit_code != 0) throw std::runtime_error("cdo failed: " + cost.out);
  }
  if (!check_answers(report, problem, has_cdo)) return;
  if (!report.options().check_only && has_cdo) measure(report, problem);
}

}  // namespace

int main(int argc, char** argv) { return run_bench(argc, argv, "sample", run); }
