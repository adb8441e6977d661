#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "api/pipeline/hindcast.h"
#include "data/store/store.h"
#include "fields/geo/geo_point.h"

namespace slackwater::tests {

/// Ingests every product file below the folders, as analysis where `as_analysis`; they came in
/// then: files of an archive long after what they hold.
void ingest_all(store::Store& store, const std::vector<std::filesystem::path>& folders,
                bool as_analysis, UtcTime received = {});

/// The cells of the stored currents that have a value at every time and every level, every
/// `every`-th row and column from index `first`: the column selections of
/// calibration/docs/baselines.md.
[[nodiscard]] std::vector<GeoPoint> wet_cells(store::Store& store, std::size_t first,
                                              std::size_t every);

/// A site whose columns are these points.
[[nodiscard]] Site site_of(const std::string& id, const std::vector<GeoPoint>& columns);

/// The baselines alone over a period, no forecast made: every column of the site.
[[nodiscard]] std::vector<calibration::SkillEntry> baseline_skill(
    store::Store& store, const Site& site, const api::HindcastOptions& options);

/// Root mean square over days of a method's error, lead (0, 24] h, one band.
[[nodiscard]] double set_error(const std::vector<calibration::SkillEntry>& skill,
                               calibration::Method method);

/// The same for each day, in the order of days.
[[nodiscard]] std::vector<double> pair_errors(const std::vector<calibration::SkillEntry>& skill,
                                              calibration::Method method);

}  // namespace slackwater::tests
