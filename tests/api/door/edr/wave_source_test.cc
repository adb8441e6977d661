// Waves that no product gave are said to be that beside their values.
#include <gtest/gtest.h>

#include "tests/api/door/edr/edr_service_for_tests.h"

namespace slackwater::tests::wave_source_test {
namespace {

std::string notes_of(const std::string& collection, DataStatus source) {
  EdrServiceForTests service;
  Snapshot snapshot = lone_forecast(5, 3);
  for (ForecastColumn& column : snapshot.columns) {
    column.sea.assign(snapshot.time.size(), SeaState{2.5, 9.0, 270});
    column.sea_source.assign(snapshot.time.size(), source);
  }
  service.issue(snapshot);
  const nlohmann::json answer = service.document("/collections/" + collection + "/locations/lone");
  const nlohmann::json& provenance = answer.at("slackwater:provenance");
  return provenance.contains("notes") ? provenance.at("notes").dump() : "";
}

TEST(EdrWaves, ComputedFromTheWindAreServedWithASentence) {
  EXPECT_NE(
      notes_of("waves", DataStatus::modelled).find("source of the waves: computed from the wind"),
      std::string::npos);
}

TEST(EdrWaves, OfAProductAreServedWithoutOneAndCurrentsToo) {
  EXPECT_EQ(notes_of("waves", DataStatus::forecast).find("source"), std::string::npos);
  EXPECT_EQ(notes_of("currents", DataStatus::modelled).find("waves"), std::string::npos);
}

}  // namespace
}  // namespace slackwater::tests::wave_source_test
