// `slackwater profile` of a forecast with an ensemble: one member, all of them, and the same bands
// beside each.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "data/store/layout.h"
#include "fields/service/field.h"
#include "tests/api/issued/commit_made_up.h"
#include "tests/support/made_up_forecast.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_profile_members_test {
namespace {

using nlohmann::json;

constexpr const char* east = "eastward_sea_water_velocity";
constexpr const char* north = "northward_sea_water_velocity";

/// A store that holds one made-up forecast at several columns.
class ProfileOfAnEnsemble : public ::testing::Test {
 protected:
  void publish(const MadeUpForecast& size) {
    store::Store store = store::Store::open(store_.store(), store::OpenMode::create_or_write);
    const Snapshot made = made_up_forecast(size);
    commit_made_up(store, made);
    // Members as rounded.
    const std::filesystem::path file =
        store::content_file(store_.store(), store.list_forecasts().front().content_sha256);
    field_.emplace(std::make_shared<const Snapshot>(ingest::read_forecast(file)));
  }
  /// At the point of the third column, half past the fifth hour.
  [[nodiscard]] ProgramResult profile(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{
        "profile", "--lat", "48.8701", "--lon", "-2.55", "--time", "2025-03-10T05:30:00Z"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return store_.run(arguments);
  }
  [[nodiscard]] json profile_json(std::vector<std::string> more = {}) const {
    more.emplace_back("--json");
    const ProgramResult result = profile(more);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return json::accept(result.out) ? json::parse(result.out) : json();
  }
  [[nodiscard]] std::vector<CurrentSample> sampled(std::size_t member) const {
    const std::vector<double>& depth_m = field_->snapshot().depth_m;
    std::vector<CurrentSample> samples(depth_m.size());
    field_->sample_profile(-2.55, 48.8701, parse_utc("2025-03-10T05:30:00Z"), depth_m, samples,
                           member);
    return samples;
  }

  StoreForTests store_;
  std::optional<Field> field_;
};

TEST_F(ProfileOfAnEnsemble, SaysHowManyMembersAndShowsTheCentralOneUnlessAsked) {
  publish({.columns = 4, .members = 5, .seed = 77});
  const json answer = profile_json();
  EXPECT_EQ(answer["members"], 5);
  EXPECT_EQ(answer["member"], 0);
  EXPECT_EQ(answer["seed"], 77);
  const auto central = sampled(0);
  ASSERT_EQ(answer["levels"].size(), central.size());
  for (std::size_t k = 0; k < central.size(); ++k) {
    EXPECT_EQ(answer["levels"][k][east]["value"], central[k].velocity_m_s.real());
    EXPECT_EQ(answer["levels"][k][east]["p50"], central[k].velocity_m_s.real());
    EXPECT_FALSE(answer["levels"][k][east].contains("members"));
  }
  EXPECT_NE(profile().out.find("5 members"), std::string::npos);
}

TEST_F(ProfileOfAnEnsemble, ShowsOneMemberBesideTheForecastsOwnBands) {
  publish({.columns = 4, .members = 5});
  const json central = profile_json();
  const json answer = profile_json({"--member", "3"});
  EXPECT_EQ(answer["member"], 3);
  const auto member = sampled(3);
  for (std::size_t k = 0; k < member.size(); ++k) {
    for (const char* component : {east, north}) {
      const json& found = answer["levels"][k][component];
      const Horizontal w = member[k].velocity_m_s;
      EXPECT_EQ(found["value"], component == east ? w.real() : w.imag());
      EXPECT_NE(found["value"], found["p50"]);
      for (const char* quantile : {"p10", "p50", "p90"})
        EXPECT_EQ(found[quantile], central["levels"][k][component][quantile]);
    }
    EXPECT_EQ(answer["levels"][k]["sea_water_speed"], std::abs(member[k].velocity_m_s));
  }
  const std::string table = profile({"--member", "3"}).out;
  EXPECT_NE(table.find("member 3 of 5 members"), std::string::npos) << table;
  char speed[32];
  std::snprintf(speed, sizeof speed, "%9.3f", std::abs(member[0].velocity_m_s));
  EXPECT_NE(table.find(speed), std::string::npos) << speed << " in " << table;
}

TEST_F(ProfileOfAnEnsemble, ListsAllMembersByNumberOnRequest) {
  publish({.columns = 4, .members = 5});
  const json answer = profile_json({"--members", "--depth", "0.5,49.9,60"});
  ASSERT_EQ(answer["levels"].size(), 3U);
  for (const char* component : {east, north}) {
    const json& list = answer["levels"][0][component]["members"];
    ASSERT_EQ(list.size(), 5U);
    EXPECT_EQ(list[0], answer["levels"][0][component]["value"]) << "number 0 is the central one";
    for (std::size_t m = 0; m < 5; ++m) {
      const Horizontal w = sampled(m)[0].velocity_m_s;
      EXPECT_EQ(list[m], component == east ? w.real() : w.imag());
    }
  }
  EXPECT_EQ(answer["levels"][2]["status"], "below_bed");
  EXPECT_FALSE(answer["levels"][2].contains(east));
}

TEST_F(ProfileOfAnEnsemble, CsvKeepsItsColumns) {
  publish({.columns = 4, .members = 5});
  const std::string central = profile({"--csv"}).out;
  const std::string member = profile({"--csv", "--member", "3"}).out;
  EXPECT_EQ(member.substr(0, member.find('\n')), central.substr(0, central.find('\n')));
  EXPECT_NE(member, central);
}

TEST_F(ProfileOfAnEnsemble, AMemberThatIsNotThereIsNotFound) {
  publish({.columns = 4, .members = 5});
  const ProgramResult result = profile({"--member", "5"});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_NE(result.err.find("members 0 (the central one) to 4"), std::string::npos) << result.err;
  EXPECT_EQ(profile({"--member", "-1"}).exit_code, 2);
  EXPECT_EQ(profile({"--member", "one"}).exit_code, 2);
  EXPECT_EQ(profile({"--members"}).exit_code, 2) << "a list is for --json";
}

TEST_F(ProfileOfAnEnsemble, OfOneMemberIsTheCentralForecastAlone) {
  publish({.columns = 4, .members = 1});
  const json answer = profile_json({"--members"});
  EXPECT_EQ(answer["members"], 1);
  EXPECT_EQ(answer["levels"][0][east]["members"].size(), 1U);
  EXPECT_EQ(profile().out.find("members"), std::string::npos);
  const ProgramResult result = profile({"--member", "1"});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_NE(result.err.find("member 0, the central one, alone"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace slackwater::tests::cli_profile_members_test
