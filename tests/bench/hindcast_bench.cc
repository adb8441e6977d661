// 28 days of hindcast of a site with 59 columns, hourly products of a synthetic ocean, verification
// included, as the program runs it. The skill is checked before the time is printed.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "api/made_up/synthetic/product_files.h"
#include "api/made_up/synthetic/synthetic_ocean.h"
#include "tests/bench/bench_report.h"
#include "tests/bench/timed_child.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace slackwater;
using namespace slackwater::bench;

constexpr int history_days =
    8;  ///< before the first day D, for the tide and the chain of calibrations
constexpr std::size_t column_count = 59;
constexpr double target_s = 60;

/// What is asked of a hindcast: few days and columns where only the answer counts.
struct Task {
  int days;
  std::size_t columns;
};

api::SyntheticOcean ocean_for(const Task& task) {
  api::SyntheticOceanSettings settings;
  settings.days = history_days + task.days + 4;
  return api::SyntheticOcean(settings);
}

/// Wet places about the site, on the cells of the product.
std::vector<GeoPoint> columns_about(const api::SyntheticOcean& ocean, std::size_t count) {
  std::vector<GeoPoint> columns;
  const GeoPoint site = ocean.settings().site;
  for (int j = -5; j <= 5; ++j) {
    for (int i = -5; i <= 5 && columns.size() < count; ++i) {
      const GeoPoint point =
          GeoPoint::from_degrees(site.latitude_deg() + j / 74.0, site.longitude_deg() + i / 33.0);
      if (!ocean.is_land(point) && ocean.water_depth_m(point) > 15.0) columns.push_back(point);
    }
  }
  return columns;
}

std::string add_columns(const std::filesystem::path& site_file,
                        const std::vector<GeoPoint>& columns) {
  std::ofstream out(site_file, std::ios::app);
  out.precision(10);
  out << "columns:\n";
  for (const GeoPoint& point : columns) {
    out << "  - {latitude_deg: " << point.latitude_deg()
        << ", longitude_deg: " << point.longitude_deg() << "}\n";
  }
  return site_file.string();
}

void fill_store(const api::SyntheticOcean& ocean, const Task& task,
                const tests::TemporaryFolder& folder) {
  const UtcDay first = ocean.settings().first_day;
  const UtcDay last = first + std::chrono::days(history_days + task.days);
  const std::filesystem::path products = folder / "products";
  std::filesystem::create_directories(products);
  const api::SyntheticGrid grid{14, 14};
  static_cast<void>(api::write_bathymetry(ocean, products, grid));
  static_cast<void>(api::write_current_product(ocean, first, last, products, grid));
  static_cast<void>(api::write_wave_product(ocean, first, last, products, grid));
  static_cast<void>(api::write_wind_analysis(ocean, first, last, products));
  slackwater_or_throw({"ingest", "--store", (folder / "store").string(), products.string()});
}

/// Root of the mean square of the vector error of the current on D+1: days, depths and columns
/// pooled.
double rmse_m_s(const nlohmann::json& skill, const std::string& method) {
  double squares = 0;
  double count = 0;
  for (const nlohmann::json& entry : skill) {
    const bool is_current = entry.contains("depth_m") && entry.contains("rmse_m_s");
    if (!is_current || entry["depth_m"].is_null() || entry["method"] != method ||
        !entry["column"].is_null())
      continue;
    if (entry["lead_h"][1].get<double>() > 24.0) continue;
    const double n = entry["n"];
    squares += n * std::pow(entry["rmse_m_s"].get<double>(), 2);
    count += n;
  }
  return count > 0 ? std::sqrt(squares / count) : std::nan("");
}

void run(BenchReport& report) {
  const bool check_only = report.options().check_only;
  const Task task = check_only ? Task{3, 3} : Task{28, column_count};
  const tests::TemporaryFolder folder;
  const api::SyntheticOcean ocean = ocean_for(task);
  const std::vector<GeoPoint> columns = columns_about(ocean, task.columns);
  const std::string site = add_columns(api::write_site_yaml(ocean, folder.path()), columns);
  fill_store(ocean, task, folder);
  const UtcDay from = ocean.settings().first_day + std::chrono::days(history_days - 1);
  const UtcDay to = from + std::chrono::days(task.days - 1);
  const ChildCost cost = slackwater_or_throw({"hindcast", "--store", (folder / "store").string(),
                                              "--site", site, "--from", format_day(from), "--to",
                                              format_day(to), "--horizon", "24h", "--json"});
  const std::string json = cost.out.substr(cost.out.find('['), cost.out.rfind(']') + 1);
  const nlohmann::json skill = nlohmann::json::parse(json);
  const double ours = rmse_m_s(skill, "forecast");
  const double persistence = rmse_m_s(skill, "persistence");
  char text[200];
  std::snprintf(text, sizeof text,
                "%zu columns, %d days, D+1 off by %.3f m/s, persistence by %.3f m/s",
                columns.size(), task.days, ours, persistence);
  // At a tidal site a forecast worth the name leaves less than two thirds of what persistence
  // leaves.
  const bool right = columns.size() == task.columns && ours < persistence * 2 / 3;
  report.answer("hindcast", right, text);
  if (!right) return;
  report.figure({"hindcast of 28 days x 59 columns, verified", "s", {cost.wall_s}, target_s, ""});
  report.figure({"  its processor time", "s", {cost.cpu_s}, std::nullopt, ""});
}

}  // namespace

int main(int argc, char** argv) { return run_bench(argc, argv, "hindcast", run); }
