#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "api/made_up/synthetic/synthetic_ocean.h"
#include "calibration/day/forecast_making.h"
#include "calibration/verify/skill_entry.h"
#include "fields/service/snapshot.h"
#include "fields/site/site.h"

namespace slackwater::api {

/// The site of the synthetic ocean, and the product that its files say they are of.
inline constexpr const char* demo_site_id = "synthetic";
inline constexpr const char* demo_product = "SYNTHETIC_OCEAN";

/// When the demonstration runs the job of day D: at 05:00 after it.
[[nodiscard]] inline UtcTime demo_issue_time(UtcDay day) {
  return UtcTime(day) + std::chrono::days(1) + std::chrono::hours(5);
}

struct DemoOptions {
  std::filesystem::path folder;  ///< product files, store and page go here
  std::uint64_t seed = 2026;
  int days = 6;  ///< consecutive daily jobs
};

/// How one day's forecast did against the known truth at the site, lead (0, 24] h, all levels.
struct DemoDay {
  UtcDay day{};
  double forecast_rmse_m_s = 0;
  double persistence_rmse_m_s = 0;  ///< the last analysed profile of D, held
  double day_mean_rmse_m_s = 0;     ///< mean of D
  double same_hour_rmse_m_s = 0;    ///< the analysed value 24 h before
  double coverage_80 = 0;           ///< share of true components inside the 80 % band
};

/// What the demonstration earned.
struct DemoResult {
  SyntheticOcean ocean;
  Site site;
  std::vector<DemoDay> days;
  std::vector<calibration::SkillEntry> skill;  ///< `verify` against the analysed products
  Snapshot last;                               ///< the newest forecast
  std::string last_sha256;                     ///< of its file in the store
  calibration::ForecastMaking last_making;     ///< how it was made
};

/// Writes a synthetic ocean as product files day by day, as they would arrive, ingests them and
/// runs the daily job at 05:00 after each day; scores every forecast against the truth and through
/// `verify`. The site's file goes into the store's own `sites/`, where `--site synthetic` finds it.
/// `say` is called with a share done and what is being done.
[[nodiscard]] DemoResult run_demo(const DemoOptions& options,
                                  const std::function<void(double, const std::string&)>& say);

}  // namespace slackwater::api
