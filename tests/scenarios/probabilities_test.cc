#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "api/made_up/demo/demo_run.h"
#include "api/pipeline/load_site_data.h"
#include "api/pipeline/verify.h"
#include "calibration/verify/skill_set.h"
#include "fields/base/text.h"
#include "tests/support/asked_number.h"
#include "tests/support/temporary_folder.h"

// Are the bands true? On the synthetic ocean the daily job runs day after day, and its spread is
// held against what came. Six days in `make test`; 210 of them with SLACKWATER_DAYS=210 (`make
// soak`), whose figures api/docs/skill.md shows.

namespace slackwater::tests::probabilities_test {
namespace {

int days_to_run() { return std::max(3, asked_number("SLACKWATER_DAYS", 6)); }

/// A forecast's and a rival's squared errors over the pairs of one day of lead and one band.
struct Against {
  double ours = 0;
  double rival = 0;
  int pairs = 0;
};

using ByLead = std::map<std::tuple<calibration::Method, double, double, double>, Against>;

/// Against the two tides, by day of lead and band of depth.
/// @param after  pairs of a later D count
ByLead against_tides(const std::vector<calibration::SkillEntry>& skill, UtcDay after) {
  ByLead all;
  for (const calibration::SkillEntry& e : skill) {
    const bool is_tide = e.method == calibration::Method::tide_phase ||
                         e.method == calibration::Method::tide_harmonic;
    if (!is_tide || e.variable != "sea_water_velocity" || !e.band || e.column) continue;
    if (e.lead.to_h - e.lead.from_h != 24 || e.day <= after || !e.forecast_rmse) continue;
    Against& one = all[{e.method, e.lead.from_h, e.band->from_m, e.band->to_m}];
    one.ours += *e.forecast_rmse * *e.forecast_rmse;
    one.rival += e.vector.rmse_m_s * e.vector.rmse_m_s;
    ++one.pairs;
  }
  return all;
}

/// Which of them the forecast does not beat, in words.
std::string lost(const ByLead& all) {
  std::string losses;
  for (const auto& [key, one] : all) {
    const auto& [method, from_h, from_m, to_m] = key;
    const double ours = std::sqrt(one.ours / one.pairs);
    const double rival = std::sqrt(one.rival / one.pairs);
    if (from_m == 0 && to_m > 1000) {
      std::printf("  from %2.0f h: forecast %.4f, %s %.4f m/s over %d pairs\n", from_h, ours,
                  std::string(name_of(method)).c_str(), rival, one.pairs);
    }
    if (ours < rival) continue;
    losses += formatted("{} from {:.0f} h in {:.0f} to {:.0f} m: {:.4f} against {:.4f}\n",
                        name_of(method), from_h, from_m, to_m, ours, rival);
  }
  return losses;
}

/// The scores of a demonstration's forecasts against the ocean itself: what is stored of the days
/// after each D is put right first, what was known at D is left as the product had it. The last D
/// goes first, so that each puts right what the one before it needs too.
std::vector<calibration::SkillEntry> scored_on_the_ocean(const api::DemoResult& demo,
                                                         const std::filesystem::path& folder) {
  store::Store store = store::Store::open(folder / "store", store::OpenMode::read_only);
  const UtcTime from(demo.days.front().day);
  const UtcTime to = UtcTime(demo.days.back().day) + std::chrono::days(4);
  SiteData data = api::load_site_data(store, demo.site, from - calibration::history_wanted, to);
  std::vector<calibration::SkillEntry> skill;
  for (auto day = demo.days.rbegin(); day != demo.days.rend(); ++day) {
    const UtcTime end = UtcTime(day->day) + std::chrono::days(1);
    for (ColumnData& column : data.columns) {
      for (PieceColumn<Horizontal>& piece : column.current.pieces) {
        VectorColumn& values = piece.column;
        for (std::size_t t = 0; t < values.times(); ++t) {
          if (values.time[t].centre() <= end) continue;
          for (std::size_t k = 0; k < values.levels(); ++k) {
            const auto truth =
                demo.ocean.current_truth(column.point, values.levels_m[k], values.time[t].centre());
            if (truth && values.has(t, k)) values.value[values.offset(t, k)] = *truth;
          }
        }
      }
    }
    calibration::VerifyOptions options;
    options.from = options.to = day->day;
    options.by_hour = false;
    const auto scored = api::verify_with(store, demo.site, data, options);
    skill.insert(skill.end(), scored.entries.begin(), scored.entries.end());
  }
  return skill;
}

/// Pairs of days weigh the same.
struct Pooled {
  calibration::SetScore forecast;     ///< of the first day of lead
  calibration::SetScore persistence;  ///< likewise
};

/// Over all depths, and printed for each day of lead.
Pooled pooled(const std::vector<calibration::SkillEntry>& skill) {
  Pooled first;
  const auto whole = calibration::whole_current(skill, WindPolicy::best, ForecastOrigin::forecast);
  for (const calibration::SkillSet& set : calibration::sets_of(whole).sets) {
    if (set.of.method == calibration::Method::persistence && set.of.lead.from_h == 0)
      first.persistence = set.score;
    if (set.of.method != calibration::Method::forecast || !set.score.vector) continue;
    if (set.of.lead.from_h == 0) first.forecast = set.score;
    const calibration::VectorSetScore& score = *set.score.vector;
    const auto interval = score.coverage_interval.value_or(calibration::Interval95{NAN, NAN});
    std::printf("  from %2.0f h: 80 %% band holds %.1f %% [%.1f, %.1f], CRPS %.4f m/s\n",
                set.of.lead.from_h, 100 * score.coverage_80.value_or(NAN), 100 * interval.low,
                100 * interval.high, score.crps_m_s.value_or(NAN));
  }
  return first;
}

TEST(Probabilities, TheBandsOfManyDaysHoldWhatTheySay) {
  const int days = days_to_run();
  const TemporaryFolder folder;
  const api::DemoResult result =
      api::run_demo({folder.path(), 2025, days}, [](double, const std::string&) {});
  const Pooled sum = pooled(result.skill);
  ASSERT_GE(sum.forecast.pairs, static_cast<std::size_t>(days - 1));
  ASSERT_TRUE(sum.forecast.vector);
  const double coverage = sum.forecast.vector->coverage_80.value_or(NAN);
  const double crps_m_s = sum.forecast.vector->crps_m_s.value_or(NAN);
  std::printf("%zu pairs: error %.4f m/s (persistence %.4f)\n", sum.forecast.pairs,
              sum.forecast.rmse, sum.persistence.rmse);
  // The tides are beaten on every day of lead, in every band, by what the product says came and by
  // what did. Of a few days the first is left out: no past has earned a weight, and the tide of
  // five days is as good as any.
  const UtcDay first = result.days.front().day;
  const UtcDay after = days >= 20 ? first - std::chrono::days(1) : first;
  std::printf(" against the product:\n");
  const ByLead on_product = against_tides(result.skill, after);
  EXPECT_EQ(lost(on_product), "");
  std::printf(" against the ocean:\n");
  const ByLead on_ocean = against_tides(scored_on_the_ocean(result, folder.path()), after);
  EXPECT_EQ(lost(on_ocean), "");
  // Three days of lead by four bands, of one tide; a harmonic tide needs fifteen days.
  EXPECT_GE(on_product.size(), days >= 20 ? 24U : 12U);
  EXPECT_EQ(on_ocean.size(), on_product.size());
  // A few days hold few independent errors; two hundred hold the band to two percent.
  EXPECT_GT(coverage, days >= 200 ? 0.78 : 0.6);
  EXPECT_LT(coverage, days >= 200 ? 0.82 : 0.97);
  // Persistence dressed with errors like its own, were they normal, has a CRPS of rmse/sqrt(2 pi).
  EXPECT_LT(crps_m_s, sum.persistence.rmse / std::sqrt(2.0 * 3.141592653589793));
}

}  // namespace
}  // namespace slackwater::tests::probabilities_test
