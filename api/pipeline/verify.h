#pragma once
#include <optional>
#include <string>
#include <vector>

#include "api/pipeline/site_data.h"
#include "calibration/skill/score.h"
#include "data/store/store.h"
#include "fields/service/snapshot.h"

namespace slackwater::api {

/// Both ends included, metres below mean sea level.
struct DepthBand {
  double from_m = 0;
  double to_m = 0;
};

/// (from, to] hours after the end of D.
struct LeadBin {
  double from_h = 0;
  double to_h = 24;
};

struct VerifyOptions {
  std::optional<UtcDay> from;  ///< day D, both ends included
  std::optional<UtcDay> to;
  std::vector<DepthBand> bands;  ///< empty: the whole column and the standard bands
  std::vector<LeadBin> leads{{0, 24}, {24, 48}, {48, 72}};
  bool per_column = false;  ///< each column beside the pooled figures
};

/// One line of skill: a method against the truth, for one issued forecast, band and lead.
struct SkillEntry {
  std::string variable;  ///< CF name of what is scored; "sea_water_velocity" for the current
  std::string site;
  std::optional<std::size_t> column;  ///< nothing: pooled over columns
  UtcDay day{};
  UtcTime issued{};
  std::string wind;
  std::optional<DepthBand> band;  ///< nothing for wind and waves
  LeadBin lead;
  std::string method;
  calibration::VectorScore vector;                 ///< for currents and wind
  std::optional<calibration::ScalarScore> scalar;  ///< for waves
  std::optional<calibration::Interval95> interval;
  std::string truth;  ///< the dataset or station it was held against
};

/// Scores one forecast of these data against the truth that the data hold now.
[[nodiscard]] std::vector<SkillEntry> score_forecast(const SiteData& data, const Snapshot& snapshot,
                                                     const std::string& dataset,
                                                     const VerifyOptions& options);

/// Scores every stored forecast of the site in the range whose truth is in: the last issued for
/// each D and wind policy. Forecasts without any truth are left out; none at all is
/// Error(not_found).
[[nodiscard]] std::vector<SkillEntry> verify(store::Store& store, const Site& site,
                                             const VerifyOptions& options);

/// The same with the site's data read already; empty where nothing is issued yet.
[[nodiscard]] std::vector<SkillEntry> verify_with(store::Store& store, const Site& site,
                                                  const SiteData& data,
                                                  const VerifyOptions& options);

/// The JSON list that `verify` and `hindcast` share (api/docs/skill_json.md).
[[nodiscard]] std::string skill_json(const std::vector<SkillEntry>& entries);

/// A table for people: per variable, band and lead one row a method, pairs of days weighing the
/// same, best first.
[[nodiscard]] std::string skill_table(const std::vector<SkillEntry>& entries);

/// Root mean square over the pairs of days of a method's error, in (0, 24] h and the widest band:
/// what a set scores.
[[nodiscard]] std::optional<double> set_rmse(const std::vector<SkillEntry>& entries,
                                             const std::string& variable, const std::string& method,
                                             const LeadBin& lead);

/// "0,150" or "0,5,20,50": edges of neighbouring bands. Throws Error(usage).
[[nodiscard]] std::vector<DepthBand> parse_bands(const std::string& text);

}  // namespace slackwater::api
