// `slackwater workability` with a bound that goes by period and heading: each step is held against
// the bound of its own sea.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "fields/base/numbers/random.h"
#include "fields/base/text.h"
#include "tests/support/contains.h"
#include "tests/support/refusal.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_workability_sea_test {
namespace {

using nlohmann::json;
using Arguments = std::vector<std::string>;

const std::string height = "sea_surface_wave_significant_height";
const std::string period = "sea_surface_wave_period_at_variance_spectral_density_maximum";
const std::string direction = "sea_surface_wave_from_direction";

/// Bounds of the rows 0 and 180 degrees at 4 and 12 s; the bow is to the west.
const std::string table =
    "limits:\n  - significant_wave_height_m:\n      peak_period_s: [4, 12]\n      rows:\n"
    "        - {from_bow_deg: 0, at_most: [2.0, 1.2]}\n"
    "        - {from_bow_deg: 180, at_most: [1.6, 0.8]}\n    heading_deg: 270\n";

double on_paper(double period_s, double from_deg) {
  const double u = std::min(std::max((period_s - 4) / 8, 0.0), 1.0);
  const double v = std::abs(std::remainder(from_deg - 270, 360.0)) / 180;
  return (1 - v) * (2.0 - 0.8 * u) + v * (1.6 - 0.8 * u);
}

struct Hour {
  double height_m, period_s, from_deg;
};

/// Two hundred hours; every seventh has no period, every eleventh no direction.
class WorkabilityBySea : public testing::Test {
 protected:
  WorkabilityBySea() {
    Rng random(9, "workability by sea");
    std::string csv = "time," + height + "," + period + "," + direction + "\n";
    std::string heights = "time," + height + "\n";
    for (int i = 0; i < 200; ++i) {
      Hour hour{std::round(100 * (0.6 + 1.4 * random.uniform())) / 100,
                std::round(10 * (3 + 11 * random.uniform())) / 10,
                std::round(360 * random.uniform())};
      const std::string time =
          format_utc(parse_utc("2002-01-01T00:00:00Z") + std::chrono::hours(i));
      csv += time + formatted(",{:.2f},", hour.height_m) +
             (i % 7 == 0 ? "" : formatted("{:.1f}", hour.period_s)) + "," +
             (i % 11 == 0 ? "" : formatted("{:.0f}", hour.from_deg)) + "\n";
      heights += time + formatted(",{:.2f}\n", hour.height_m);
      if (i % 7 == 0) hour.period_s = std::nan("");
      if (i % 11 == 0) hour.from_deg = std::nan("");
      hours_.push_back(hour);
    }
    file_ = store_.write("sea.csv", csv);
    heights_ = store_.write("heights.csv", heights);
    limit_ = store_.write("ctv.yaml", table);
  }
  /// The worst along an axis that nobody knows is at one of its ends here.
  [[nodiscard]] static double bound_of(const Hour& hour) {
    const double slow = std::isnan(hour.period_s) ? 12 : hour.period_s;
    const double astern = std::isnan(hour.from_deg) ? 90 : hour.from_deg;
    return on_paper(slow, astern);
  }
  ProgramResult run(Arguments arguments) const {
    arguments.insert(arguments.begin(), "workability");
    return store_.run(arguments);
  }
  json answer(Arguments arguments) const {
    arguments.emplace_back("--json");
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return json::accept(result.out) ? json::parse(result.out) : json();
  }

  StoreForTests store_;
  std::vector<Hour> hours_;
  std::string file_, heights_, limit_;
};

TEST_F(WorkabilityBySea, HoldsEachHourAgainstTheBoundOfItsSea) {
  int holds = 0;
  for (const Hour& hour : hours_) holds += hour.height_m <= bound_of(hour) ? 1 : 0;
  ASSERT_GT(holds, 40);
  ASSERT_LT(holds, 160);
  const json found = answer({file_, "--limit", limit_, "--duration", "1h"});
  EXPECT_NEAR(found.at("accessibility").get<double>(), holds / 200.0, 1e-12);
  EXPECT_EQ(found.at("missing_steps"), 0) << "a height is all that is needed";
  EXPECT_TRUE(found.at("limits")[0].at("value").is_null());
  EXPECT_TRUE(contains(found.at("limits")[0].at("limit").get<std::string>(),
                       "ctv.yaml: significant wave height at most 0.8 to 2 m by peak period"));
}

TEST_F(WorkabilityBySea, WithoutTheSeriesTheWorstCountsAndIsTold) {
  int holds = 0;
  for (const Hour& hour : hours_) holds += hour.height_m <= 0.8 ? 1 : 0;
  const json found = answer({heights_, "--limit", limit_, "--duration", "1h"});
  EXPECT_NEAR(found.at("accessibility").get<double>(), holds / 200.0, 1e-12);
  const std::string notes = found.at("notes").dump();
  EXPECT_TRUE(contains(notes, "found no " + period + ": the worst of all periods counts")) << notes;
  EXPECT_TRUE(contains(notes, "found no " + direction + ": the worst of all headings counts"));
  // And without a bow.
  std::string no_bow = table.substr(0, table.find("    heading_deg"));
  const std::string file = store_.write("no_bow.yaml", no_bow);
  const json any = answer({file_, "--limit", file, "--duration", "1h"});
  holds = 0;
  for (Hour hour : hours_) {
    hour.from_deg = std::nan("");
    holds += hour.height_m <= bound_of(hour) ? 1 : 0;
  }
  EXPECT_NEAR(any.at("accessibility").get<double>(), holds / 200.0, 1e-12);
  EXPECT_TRUE(contains(any.at("notes").dump(), "found no heading_deg of the bow"));
}

TEST_F(WorkabilityBySea, CampaignsNameTheirFileToo) {
  const auto campaign = [&](const std::string& limit) {
    return answer({file_, "--campaign",
                   store_.write("campaign.yaml",
                                "begin: [01-01]\ntasks:\n  - {name: a, times: 5, duration: 1h, "
                                "limits: ['" +
                                    limit + "']}\n")})
        .at("seasons");
  };
  const json by_table = campaign("ctv.yaml");
  // Five accessible hours, one after the other, from the first on.
  int wanted = 5;
  std::size_t end = 0;
  while (wanted > 0 && end < hours_.size()) {
    wanted -= hours_[end].height_m <= bound_of(hours_[end]) ? 1 : 0;
    ++end;
  }
  ASSERT_EQ(wanted, 0);
  EXPECT_NEAR(by_table.at(0).at("elapsed_h").at("p50").get<double>(), static_cast<double>(end),
              1e-9);
  EXPECT_NE(by_table, campaign(height + "<=0.9"));
}

TEST_F(WorkabilityBySea, RefusesAFileWithoutOneTable) {
  const auto refused = [&](const std::string& yaml, const std::vector<std::string>& words) {
    expect_refusal(run({file_, "--duration", "1h", "--limit", store_.write("bad.yaml", yaml)}), 3,
                   words);
  };
  refused("limits: [{significant_wave_height_m: 1.5}]\n", {"bad.yaml", "expected one limit"});
  refused("limits: [{current_speed_m_s: 1.5}]\n", {"expected one limit"});
  refused("limits: []\n", {"expected one limit"});
  refused("significant_wave_height_m: {peak_period_s: [4, 8], at_most: [1, 1]}\n",
          {"bad.yaml", "significant_wave_height_m"});
  expect_refusal(run({file_, "--duration", "1h", "--limit", store_.path("nowhere.yaml")}), 4,
                 {"nowhere.yaml"});
}

}  // namespace
}  // namespace slackwater::tests::cli_workability_sea_test
