// A product's sea that no water could hold is served, with a sentence.
#include <gtest/gtest.h>

#include "tests/api/door/edr/edr_service_for_tests.h"

namespace slackwater::tests::steep_sea_test {
namespace {

/// What the answer about waves says beside its values, with such a sea in the forecast.
std::string notes_with(SeaState sea) {
  EdrServiceForTests service;
  Snapshot snapshot = lone_forecast(5, 3);
  for (ForecastColumn& column : snapshot.columns) column.sea.assign(snapshot.time.size(), sea);
  for (ForecastColumn& column : snapshot.columns)
    column.sea_source.assign(snapshot.time.size(), DataStatus::forecast);
  service.issue(snapshot);
  const nlohmann::json answer = service.document("/collections/waves/locations/lone");
  const nlohmann::json& heights =
      answer.at("ranges").at("sea_surface_wave_significant_height").at("values");
  EXPECT_DOUBLE_EQ(heights.at(0).get<double>(), sea.significant_height_m)
      << "as the product has it";
  const nlohmann::json& provenance = answer.at("slackwater:provenance");
  return provenance.contains("notes") ? provenance.at("notes").dump() : "";
}

TEST(EdrWaves, ASeaTooSteepToStandIsServedWithASentence) {
  // 2 pi 4/(g 4^2) = 0.160 (LOTUSim's SSC4, fields/docs/physics.md, 8), beyond 1/15.
  EXPECT_NE(notes_with({4.0, 4.0, 270}).find("steeper than real waves"), std::string::npos);
}

TEST(EdrWaves, ASeaThatStandsIsServedWithoutOne) {
  EXPECT_EQ(notes_with({2.5, 9.0, 270}).find("steep"), std::string::npos);
}

}  // namespace
}  // namespace slackwater::tests::steep_sea_test
