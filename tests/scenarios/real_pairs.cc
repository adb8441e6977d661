#include "tests/scenarios/real_pairs.h"

#include <cmath>
#include <limits>

#include "api/pipeline/ingest/ingest_files.h"
#include "api/pipeline/load_site_data.h"
#include "calibration/day/daily_forecast.h"
#include "calibration/verify/score_forecast.h"
#include "calibration/verify/skill_set.h"
#include "fields/record/leading_dataset.h"
#include "ingest/cf/granule_file.h"
#include "ingest/copernicus/product_catalogue.h"
#include "tests/support/shared_data.h"

namespace slackwater::tests {

void ingest_all(store::Store& store, const std::vector<std::filesystem::path>& folders,
                bool as_analysis, UtcTime received) {
  const auto products = ingest::ProductCatalogue::load(source_folder() / "data" / "products");
  ingest::IngestOptions options;
  if (as_analysis) options.as = DataStatus::analysis;
  for (const auto& file : api::product_files(folders)) {
    static_cast<void>(api::ingest_file(store, products, file, options, received, {}));
  }
}

std::vector<GeoPoint> wet_cells(store::Store& store, std::size_t first, std::size_t every) {
  std::vector<bool> wet;
  Grid grid;
  store::GranuleQuery query;
  query.any_of = {"eastward_sea_water_velocity"};
  for (const store::GranuleRow& row : store.find_granules(query)) {
    const auto file = ingest::GranuleFile::open(store.content_path(row.content_sha256));
    grid = file.granule().grid;
    const GriddedField u = file.read("eastward_sea_water_velocity", 0, grid.times(), 0, grid.rows(),
                                     0, grid.columns());
    wet.resize(grid.rows() * grid.columns(), true);
    for (std::size_t o = 0; o < u.values.size(); ++o) {
      if (std::isnan(u.values[o])) wet[o % wet.size()] = false;
    }
  }
  std::vector<GeoPoint> points;
  for (std::size_t j = first; j < grid.rows(); j += every) {
    for (std::size_t i = first; i < grid.columns(); i += every) {
      if (wet[j * grid.columns() + i]) {
        points.push_back(GeoPoint::from_degrees(grid.latitude_deg[j], grid.longitude_deg[i]));
      }
    }
  }
  return points;
}

Site site_of(const std::string& id, const std::vector<GeoPoint>& columns) {
  Site site;
  site.id = id;
  site.name = id;
  site.point = columns.front();
  site.columns = columns;
  return site;
}

std::vector<calibration::SkillEntry> baseline_skill(store::Store& store, const Site& site,
                                                    const api::HindcastOptions& options) {
  const UtcTime last = UtcTime(options.to) + std::chrono::days(1) + options.horizon;
  const SiteData data =
      api::load_site_data(store, site, UtcTime(options.from) - calibration::history_wanted, last);
  std::vector<calibration::SkillEntry> skill;
  for (UtcDay day = options.from; day <= options.to; day += std::chrono::days(1)) {
    Snapshot empty;
    empty.site_id = site.id;
    empty.day = day;
    empty.issued = UtcTime(day) + std::chrono::days(1);
    empty.wind_policy = options.wind;
    empty.time = {empty.issued, empty.issued + options.horizon};
    for (const ColumnData& column : data.columns) {
      empty.columns.emplace_back();
      empty.columns.back().point = column.point;
      empty.columns.back().water_depth_m = column.water_depth.depth_m;
    }
    const auto dataset = leading_dataset(data.columns.front().current, UtcTime(day), empty.issued);
    if (!dataset) continue;
    const auto scored =
        calibration::score_forecast(data, empty, {*dataset}, options.verify).entries;
    skill.insert(skill.end(), scored.begin(), scored.end());
  }
  return skill;
}

std::vector<double> pair_errors(const std::vector<calibration::SkillEntry>& skill,
                                calibration::Method method) {
  std::vector<double> errors;
  const calibration::LeadBin whole_day{0, 24};
  for (const calibration::SkillEntry& entry : skill) {
    if (entry.variable == "sea_water_velocity" && entry.method == method && !entry.column &&
        entry.lead == whole_day)
      errors.push_back(entry.vector.rmse_m_s);
  }
  return errors;
}

double set_error(const std::vector<calibration::SkillEntry>& skill, calibration::Method method) {
  const std::vector<double> errors = pair_errors(skill, method);
  return errors.empty() ? std::numeric_limits<double>::quiet_NaN()
                        : calibration::rmse_of_pairs(errors);
}

}  // namespace slackwater::tests
