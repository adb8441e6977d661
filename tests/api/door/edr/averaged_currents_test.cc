// Currents that are means over hours, and forecasts made in hindsight, say so in every answer.
#include <gtest/gtest.h>

#include "tests/api/door/edr/edr_service_for_tests.h"

namespace slackwater::tests::averaged_currents_test {
namespace {

using std::chrono::hours;

std::string notes_of(const Snapshot& snapshot, const std::string& collection) {
  EdrServiceForTests service;
  service.issue(snapshot);
  const nlohmann::json answer = service.document("/collections/" + collection + "/locations/lone");
  const nlohmann::json& provenance = answer.at("slackwater:provenance");
  return provenance.contains("notes") ? provenance.at("notes").dump() : "";
}

TEST(EdrNotes, TellTheCurrentsThatAreMeansAndLeaveTheWavesAlone) {
  Snapshot snapshot = lone_forecast(5, 3);
  EXPECT_EQ(notes_of(snapshot, "currents").find("means"), std::string::npos);
  snapshot.averaged = AveragedCurrents{hours(24), false, std::nullopt, ""};
  EXPECT_NE(notes_of(snapshot, "currents").find("daily means: they do not hold the tide"),
            std::string::npos);
  EXPECT_EQ(notes_of(snapshot, "waves").find("means"), std::string::npos);
}

TEST(EdrNotes, TellAForecastMadeInHindsight) {
  Snapshot snapshot = lone_forecast(5, 3);
  EXPECT_EQ(notes_of(snapshot, "currents").find("hindsight"), std::string::npos);
  snapshot.hindsight = true;
  EXPECT_NE(notes_of(snapshot, "currents").find("hindsight"), std::string::npos);
}

}  // namespace
}  // namespace slackwater::tests::averaged_currents_test
