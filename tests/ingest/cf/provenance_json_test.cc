#include "ingest/cf/forecast/provenance_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fields/base/error.h"

namespace slackwater::ingest::provenance_json_test {
namespace {

Provenance whole() {
  Provenance provenance;
  provenance.site = "otranto";
  provenance.issued = parse_utc("2024-03-01T05:00:00Z");
  provenance.inputs = {{"med_currents", {"0a", "0b"}}, {"wind", {}}};
  provenance.code_version = "0.1.0";
  provenance.calibration = {
      "finite_depth", 0.03125, "converged", {{"bottom_friction", 0.5}, {"eddy_viscosity", 0.1}}};
  return provenance;
}

TEST(ProvenanceJson, IsTheAttributeOfForecastFiles) {
  EXPECT_EQ(provenance_json(whole()),
            R"({"calibration":{"form":"finite_depth","parameters":{"bottom_friction":0.5,)"
            R"("eddy_viscosity":0.1},"rms_m_s":0.03125,"termination":"converged"},)"
            R"("code_version":"0.1.0","inputs":[{"product":"med_currents","sha256":["0a","0b"]},)"
            R"({"product":"wind","sha256":[]}],"issued":"2024-03-01T05:00:00Z","site":"otranto"})");
  EXPECT_EQ(provenance_json({}), R"({"inputs":[]})") << "what is not known is left out";
}

TEST(ProvenanceJson, ComesBackToTheBit) {
  Provenance provenance = whole();
  provenance.calibration->rms_m_s = 0.1 + 0.2;
  EXPECT_EQ(provenance_from(provenance_json(provenance)), provenance);
  EXPECT_EQ(provenance_from(provenance_json({})), Provenance{});
  provenance.calibration->rms_m_s = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(provenance_from(provenance_json(provenance)).calibration->rms_m_s));
}

TEST(ProvenanceJson, PassesOverWhatLaterVersionsMayAdd) {
  EXPECT_EQ(provenance_from(R"({"inputs":[],"seed":7})"), Provenance{});
}

TEST(ProvenanceJson, RefusesWhatIsNoProvenance) {
  for (const char* text :
       {"", "none", "[]", "7", "{}", R"({"inputs":7})", R"({"inputs":[{"product":1}]})",
        R"({"inputs":[],"issued":"yesterday"})", R"({"inputs":[],"calibration":null})",
        R"({"inputs":[],"calibration":{"form":"a","rms_m_s":"b","termination":"c"}})"}) {
    try {
      (void)provenance_from(text);
      ADD_FAILURE() << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::invalid_input) << text;
    }
  }
}

}  // namespace
}  // namespace slackwater::ingest::provenance_json_test
