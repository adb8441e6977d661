#include "calibration/day/issued_snapshot.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "calibration/day/given/driving_ensemble.h"
#include "fields/base/text.h"

namespace slackwater::calibration {

Snapshot snapshot_of(const SiteData& data, const ForecastPlan& plan,
                     const std::vector<ColumnForecast>& columns) {
  Snapshot snapshot;
  snapshot.site_id = data.site.id;
  snapshot.site_name = data.site.name;
  snapshot.day = plan.day;
  snapshot.issued = plan.issued;
  snapshot.wind_policy = plan.wind;
  snapshot.time = plan.stamps;
  snapshot.depth_m = plan.depth_m;
  snapshot.seed = plan.seed;
  std::set<std::string> attributions;
  std::set<std::string> ensembles;
  const std::size_t values = plan.stamps.size() * plan.depth_m.size();
  for (const ColumnForecast& column : columns) {
    for (const Origin* origin : column.origins) {
      if (!origin->attribution.empty()) attributions.insert(origin->attribution);
    }
    snapshot.contains_stokes = snapshot.contains_stokes || column.contains_stokes;
    snapshot.hindsight = snapshot.hindsight || column.hindsight;
    snapshot.simulated_wind = snapshot.simulated_wind || column.simulated_wind;
    if (column.wind_ensemble) ensembles.insert(text_of(*column.wind_ensemble));
    snapshot.columns.push_back(column.column);
    if (values > 0)
      snapshot.members = std::max(snapshot.members, 1 + column.column.member_m_s.size() / values);
  }
  snapshot.attributions.assign(attributions.begin(), attributions.end());
  snapshot.wind_ensemble = joined(ensembles, "; ");
  return snapshot;
}

Provenance provenance_of(const SiteData& data, const ForecastOptions& options,
                         const std::vector<ColumnForecast>& columns) {
  Provenance provenance;
  provenance.site = data.site.id;
  provenance.issued = options.issued;
  provenance.code_version = options.code_version;
  std::map<std::string, std::set<std::string>> products;
  for (const ColumnForecast& column : columns) {
    for (const Origin* origin : column.origins)
      products[origin->product_id].insert(origin->sources.begin(), origin->sources.end());
  }
  for (const auto& [product, files] : products)
    provenance.inputs.push_back({product, {files.begin(), files.end()}});
  const Calibration* const fitted = columns.empty() ? nullptr : columns.front().calibration();
  if (fitted == nullptr) return provenance;
  CalibrationSummary& summary = provenance.calibration.emplace();
  summary.form = name_of(fitted->form);
  summary.rms_m_s = fitted->rms_m_s;
  summary.termination = fitted->termination;
  for (const Parameter& parameter : fitted->parameters)
    summary.parameters[parameter.name] = parameter.value;
  return provenance;
}

std::vector<std::int64_t> granules_of(const std::vector<ColumnForecast>& columns) {
  std::set<std::int64_t> granules;
  for (const ColumnForecast& column : columns) {
    for (const Origin* origin : column.origins)
      granules.insert(origin->granules.begin(), origin->granules.end());
  }
  return {granules.begin(), granules.end()};
}

}  // namespace slackwater::calibration
