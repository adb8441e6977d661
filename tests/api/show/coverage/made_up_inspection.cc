#include "tests/api/show/coverage/made_up_inspection.h"

#include <cmath>
#include <initializer_list>
#include <limits>
#include <string>

#include "fields/base/text.h"

namespace slackwater::tests {
namespace {

using ingest::TrajectoryFile;
using ingest::TrajectoryTable;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double pi = 3.141592653589793;
constexpr double radius_m = 3, pile_high_m = 35, bed_side_m = 40;

TrajectoryTable table_of(const char* name, std::initializer_list<const char*> columns) {
  TrajectoryTable table;
  table.name = name;
  for (const char* column : columns) table.columns.push_back({column, "1", "", {}});
  return table;
}

void add(TrajectoryTable& table, std::initializer_list<double> row) {
  std::size_t c = 0;
  for (const double value : row) table.columns[c++].values.push_back(value);
}

/// How a place was seen: its row's share of the depth, or of the bed from west to east, decides.
struct Seen {
  double detail_m = nothing, incidence_deg = nothing, range_m = nothing, t_s = nothing;
  double looks = 0, covered = 0;
};

Seen seen_of(double share, double around, double covered_to, double seen_to, double detail_m) {
  Seen seen;
  if (share >= seen_to) return seen;
  seen.covered = share < covered_to ? 1 : 0;
  seen.range_m = 1.5 + 2 * share + 0.3 * std::cos(around);
  seen.detail_m = detail_m * (seen.covered == 1 ? 0.5 : 1.4) * (0.5 + seen.range_m / 4);
  seen.incidence_deg = 20 + 15 * std::sin(3 * around);
  seen.t_s = 60 + 3000 * share + 10 * around;
  seen.looks = 2;
  return seen;
}

void add_pile(const MadeUpInspection& how, TrajectoryTable& patches) {
  const double round_m = 2 * pi * radius_m;
  const double width_m = round_m / static_cast<double>(how.columns);
  const double height_m = pile_high_m / static_cast<double>(how.rows);
  for (std::size_t r = 0; r < how.rows; ++r)
    for (std::size_t c = 0; c < how.columns; ++c) {
      const double share = (static_cast<double>(r) + 0.5) / static_cast<double>(how.rows);
      const double bearing =
          2 * pi * (static_cast<double>(c) + 0.5) / static_cast<double>(how.columns);
      const double e = std::sin(bearing), n = std::cos(bearing);
      const Seen s = seen_of(share, bearing, 0.6, 0.8, 0.003);
      add(patches, {0, bearing * radius_m, share * pile_high_m, width_m, height_m, radius_m * e,
                    radius_m * n, -share * pile_high_m, e, n, 0, width_m * height_m, s.detail_m,
                    s.incidence_deg, s.range_m, s.t_s, s.looks, s.covered});
    }
}

void add_bed(TrajectoryTable& patches) {
  constexpr std::size_t side = 40;
  constexpr double width_m = bed_side_m / side;
  for (std::size_t r = 0; r < side; ++r)
    for (std::size_t c = 0; c < side; ++c) {
      const double along = (static_cast<double>(c) + 0.5) * width_m;
      const double down = (static_cast<double>(r) + 0.5) * width_m;
      const double e = along - bed_side_m / 2, n = bed_side_m / 2 - down;
      const double deep = 2 * std::exp(-(e * e + n * n) / 50);
      const Seen s = seen_of(along / bed_side_m, down / bed_side_m, 0.5, 0.75, 0.1);
      add(patches, {1, along, down, width_m, width_m, e, n, -35 - deep, 0, 0, 1, width_m * width_m,
                    s.detail_m, s.incidence_deg, s.range_m, s.t_s, s.looks, s.covered});
    }
}

/// Kinds by number: 0 crack, 1 corrosion, 2 marine growth, 6 scour.
void add_findings(bool has_bed, TrajectoryTable& findings) {
  const auto on_pile = [&](double kind, double outcome, double defect, double bearing_deg,
                           double depth_m, double size_m, double true_size_m) {
    const double bearing = bearing_deg * pi / 180;
    const double x = radius_m * std::sin(bearing), y = radius_m * std::cos(bearing);
    const bool is_reported = outcome < 2, is_there = outcome != 1;
    const auto told = [&](double value) { return is_reported ? value : nothing; };
    const auto truly = [&](double value) { return is_there ? value : nothing; };
    add(findings,
        {0, kind, outcome, defect, bearing * radius_m, depth_m, told(x + 0.06), told(y - 0.08),
         told(-depth_m), truly(x), truly(y), truly(-depth_m), told(size_m), truly(true_size_m),
         told(0.004), truly(0.005), told(60 + 80 * depth_m), told(0.002)});
  };
  on_pile(1, 0, 0, 140, 6, 0.32, 0.30);
  on_pile(0, 0, 1, 214, 12.3, 0.05, 0.06);
  on_pile(1, 1, -1, 300, 17, 0.11, nothing);
  on_pile(0, 2, 2, 180, 33, nothing, 0.08);
  on_pile(2, 3, 3, 250, 24, nothing, 0.50);
  on_pile(0, 4, 4, 90, 9, nothing, 0.02);
  if (has_bed)
    add(findings,
        {1, 6, 0, 5, 18, 20, -2.2, 0.1, -36.8, -2, 0, -36.85, 4.1, 4, 1.7, 1.85, 1500, 0.05});
}

/// Sums as the run itself would make them.
struct Sums {
  double area_m2 = 0, seen_m2 = 0, covered_m2 = 0;
};
Sums sums_of(const TrajectoryTable& patches, double pair) {
  Sums sums;
  const auto &pairs = *patches.column("pair"), &areas = *patches.column("area"),
             &looks = *patches.column("looks"), &covered = *patches.column("covered");
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (pairs[i] != pair) continue;
    sums.area_m2 += areas[i];
    if (looks[i] > 0) sums.seen_m2 += areas[i];
    if (covered[i] > 0) sums.covered_m2 += areas[i];
  }
  return sums;
}

std::string entry(const char* what, double width_m, double height_m, const char* axes, double top_m,
                  const Sums& s, const char* details) {
  return formatted(
      "{{\"vehicle\":0,{},\"done_at\":0.9,\"sheet\":{{\"width_m\":{},"
      "\"height_m\":{},{},\"first_bearing_deg\":0,\"top_z_m\":{}}},\"area_m2\":{},"
      "\"seen_m2\":{},\"covered_m2\":{},{}}}",
      what, width_m, height_m, axes, top_m, s.area_m2, s.seen_m2, s.covered_m2, details);
}

TrajectoryFile rov_log() {
  TrajectoryFile log;
  log.names = {"rov"};
  log.epoch = parse_utc("2025-03-10T06:00:00Z");
  std::vector<double> x, y, z;
  for (double t = 0; t <= 3600; t += 60) {
    log.t_s.push_back(t);
    x.push_back(5 * std::sin(t / 300));
    y.push_back(5 * std::cos(t / 300));
    z.push_back(-35 * t / 3600);
  }
  log.variables = {{"x", "", "m", "", 1, x}, {"y", "", "m", "", 1, y}, {"z", "", "m", "", 1, z}};
  log.attributes = {{"title", "a look at a pile"},
                    {"source", "slackwater test"},
                    {"origin", "48.850000000 N, -2.550000000 E"}};
  return log;
}

}  // namespace

TrajectoryFile made_up_inspection(const MadeUpInspection& how) {
  TrajectoryFile log = rov_log();
  TrajectoryTable patches =
      table_of("inspected_patches",
               {"pair", "along", "down", "width", "height", "x", "y", "z", "normal_x", "normal_y",
                "normal_z", "area", "detail", "incidence", "range", "time", "looks", "covered"});
  add_pile(how, patches);
  if (how.has_bed) add_bed(patches);
  TrajectoryTable findings =
      table_of("findings", {"pair", "kind", "outcome", "defect", "along", "down", "x", "y", "z",
                            "true_x", "true_y", "true_z", "size", "true_size", "severity",
                            "true_severity", "time", "detail"});
  add_findings(how.has_bed, findings);
  std::string text =
      "[" + entry(
                "\"surface\":\"A01/monopile\",\"kind\":\"monopile\",\"instrument\":\"ROV "
                "camera\",\"detail_m\":0.003,\"incidence_deg\":60,\"looks\":1",
                2 * pi * radius_m, pile_high_m,
                "\"is_all_round\":true,\"along\":\"clockwise from north\",\"down\":\"downwards\"",
                0, sums_of(patches, 0), "\"least_detail_m\":0.0013,\"median_detail_m\":0.0018");
  if (how.has_bed)
    text += "," + entry(
                      "\"surface\":\"A01/bed\",\"kind\":\"bed\",\"instrument\":\"multibeam\","
                      "\"detail_m\":0.1,\"incidence_deg\":60,\"looks\":2",
                      bed_side_m, bed_side_m,
                      "\"is_all_round\":false,\"along\":\"eastwards\",\"down\":\"southwards\"", 35,
                      sums_of(patches, 1), "\"least_detail_m\":0.044,\"median_detail_m\":null");
  log.attributes.emplace_back("inspection", text + "]");
  log.tables = {patches, findings};
  return log;
}

}  // namespace slackwater::tests
