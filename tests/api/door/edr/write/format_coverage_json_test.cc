#include "api/door/edr/write/format_coverage_json.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "fields/base/check.h"
#include "tests/api/door/edr/made_up_answer.h"

namespace slackwater::api::edr::format_coverage_json_test {
namespace {

using nlohmann::json;
using tests::made_up_answer;
using tests::made_up_value;

json written(const Answer& answer) { return json::parse(coverage_json(answer)); }

/// Claims that ranges hold the values of the answer, to six digits and in order.
void expect_values(const json& ranges, const Answer& answer, std::size_t coverage) {
  for (std::size_t p = 0; p < answer.parameters.size(); ++p) {
    const json& values = ranges.at(answer.parameters[p].name).at("values");
    ASSERT_EQ(values.size(), answer.coverages[coverage].values[p].size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (p == 1 && i == 0) {
        EXPECT_TRUE(values[i].is_null());
      } else {
        EXPECT_NEAR(values[i].get<double>(), made_up_value(coverage, p, i), 1e-6);
      }
    }
  }
}

struct Kind {
  DomainType type;
  const char* name;
  json axis_names, shape;
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{{DomainType::point, "Point", json::array(), json::array()},
                                     {DomainType::point_series, "PointSeries", {"t"}, {25}},
                                     {DomainType::vertical_profile, "VerticalProfile", {"z"}, {4}},
                                     {DomainType::grid, "Grid", {"t", "z", "y", "x"}, {2, 4, 2, 3}},
                                     {DomainType::trajectory, "Trajectory", {"composite"}, {5}}};
  return all;
}

TEST(CoverageJson, EveryDomainTypeHasItsAxesShapeAndValues) {
  for (const Kind& kind : kinds()) {
    SCOPED_TRACE(kind.name);
    const Answer answer = made_up_answer(kind.type);
    const json body = written(answer);
    EXPECT_EQ(body.at("type"), "Coverage");
    EXPECT_EQ(body.at("id"), "place-0");
    EXPECT_EQ(body.at("domain").at("domainType"), kind.name);
    expect_values(body.at("ranges"), answer, 0);
    for (const auto& [name, range] : body.at("ranges").items()) {
      EXPECT_EQ(range.at("type"), "NdArray");
      EXPECT_EQ(range.at("dataType"), "float");
      EXPECT_EQ(range.at("axisNames"), kind.axis_names) << name;
      EXPECT_EQ(range.at("shape"), kind.shape) << name;
    }
  }
}

TEST(CoverageJson, AxesAreThoseOfTheDomain) {
  const json axes = written(made_up_answer(DomainType::grid)).at("domain").at("axes");
  EXPECT_EQ(axes.at("x"), json::parse(R"({"values":[2.45,2.55,2.65]})"));
  EXPECT_EQ(axes.at("y"), json::parse(R"({"values":[57.25,57.3125]})"));
  EXPECT_EQ(axes.at("z"), json::parse(R"({"values":[0.5,10.5,20.5,30.5]})"));
  EXPECT_EQ(axes.at("t"),
            json::parse(R"({"values":["2025-03-10T00:00:00Z","2025-03-10T01:00:00Z"]})"));
}

TEST(CoverageJson, ATrajectoryIsTuplesOfTimePlaceAndLevel) {
  Answer answer = made_up_answer(DomainType::trajectory);
  json axis = written(answer).at("domain").at("axes").at("composite");
  EXPECT_EQ(axis.at("dataType"), "tuple");
  EXPECT_EQ(axis.at("coordinates"), json({"t", "x", "y", "z"}));
  EXPECT_EQ(axis.at("values")[1], json::parse(R"(["2025-03-10T01:00:00Z",2.4623457,57.26,5])"));
  answer.coverages[0].vertical_m = {7};
  const json axes = written(answer).at("domain").at("axes");
  EXPECT_EQ(axes.at("composite").at("coordinates"), json({"t", "x", "y"}));
  EXPECT_EQ(axes.at("z"), json::parse(R"({"values":[7]})"));
}

TEST(CoverageJson, ATrajectoryThatReturnsAtTheSameInstantSaysSoOnce) {
  Answer answer = made_up_answer(DomainType::trajectory);
  Coverage& line = answer.coverages[0];
  line.time.resize(1);
  line.vertical_m.resize(1);
  line.longitude_deg.back() = line.longitude_deg.front();
  line.latitude_deg.back() = line.latitude_deg.front();
  const json body = written(answer);
  EXPECT_EQ(body.at("domain").at("axes").at("composite").at("values").size(), 4U);
  const json& range = body.at("ranges").at(answer.parameters[0].name);
  EXPECT_EQ(range.at("shape"), json({4}));
  EXPECT_EQ(range.at("values").size(), 4U);
}

TEST(CoverageJson, SeveralCoveragesShareParametersAndSystems) {
  for (const Kind& kind : kinds()) {
    SCOPED_TRACE(kind.name);
    const Answer answer = made_up_answer(kind.type, 3);
    const json body = written(answer);
    EXPECT_EQ(body.at("type"), "CoverageCollection");
    EXPECT_EQ(body.at("domainType"), kind.name);
    ASSERT_EQ(body.at("coverages").size(), 3U);
    EXPECT_EQ(body.at("parameters").size(), 3U);
    EXPECT_EQ(body.at("referencing").size(), 3U);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(body.at("coverages")[c].at("id"), "place-" + std::to_string(c));
      expect_values(body.at("coverages")[c].at("ranges"), answer, c);
    }
  }
  Answer none = made_up_answer(DomainType::grid, 0);
  EXPECT_EQ(written(none).at("coverages"), json::array());
}

TEST(CoverageJson, DepthCountsDownAndHeightUp) {
  Answer answer = made_up_answer(DomainType::vertical_profile);
  const auto vertical = [&] { return written(answer).at("domain").at("referencing")[1]; };
  EXPECT_EQ(vertical().at("coordinates"), json({"z"}));
  EXPECT_EQ(vertical().at("system").at("type"), "VerticalCRS");
  EXPECT_EQ(vertical().at("system").at("cs").at("csAxes")[0].at("direction"), "down");
  answer.vertical = Vertical::height_up;
  EXPECT_EQ(vertical().at("system").at("cs").at("csAxes")[0].at("direction"), "up");
}

TEST(CoverageJson, AnAxisThatIsNotThereHasNoSystem) {
  Answer answer = made_up_answer(DomainType::point);
  answer.vertical = Vertical::none;
  answer.coverages[0].vertical_m.clear();
  answer.coverages[0].time.clear();
  const json domain = written(answer).at("domain");
  EXPECT_EQ(domain.at("referencing").size(), 1U);
  EXPECT_EQ(domain.at("referencing")[0].at("system").at("id"),
            "http://www.opengis.net/def/crs/OGC/1.3/CRS84");
  EXPECT_FALSE(domain.at("axes").contains("z") || domain.at("axes").contains("t"));
}

TEST(CoverageJson, AParameterNamesItsQuantityUnitAndMethod) {
  const json body = written(made_up_answer(DomainType::point));
  const json& quantile = body.at("parameters").at("eastward_sea_water_velocity_p10");
  EXPECT_EQ(quantile.at("type"), "Parameter");
  EXPECT_EQ(quantile.at("observedProperty").at("id"),
            "http://vocab.nerc.ac.uk/standard_name/eastward_sea_water_velocity/");
  EXPECT_EQ(quantile.at("observedProperty").at("label").at("en"), "eastward current");
  EXPECT_EQ(quantile.at("unit").at("symbol").at("value"), "m/s");
  EXPECT_EQ(quantile.at("measurementType").at("method"), "quantile 0.1");
}

TEST(CoverageJson, ProvenanceIsInEveryAnswer) {
  for (const std::size_t coverages : {1, 2}) {
    const json from =
        written(made_up_answer(DomainType::point, coverages)).at("slackwater:provenance");
    EXPECT_EQ(from.at("site"), "utsira-nord");
    EXPECT_EQ(from.at("issued"), "2025-03-10T05:00:00Z");
    EXPECT_EQ(from.at("day"), "2025-03-09");
    EXPECT_EQ(from.at("degraded"), true);
    EXPECT_EQ(from.at("attributions")[0], "© E.U. Copernicus Marine Service Information");
    EXPECT_EQ(from.at("notes")[0], "below the bed at 10 m");
  }
}

TEST(CoverageJson, AnAnswerThatIsNotWholeIsABug) {
  Answer answer = made_up_answer(DomainType::vertical_profile);
  answer.coverages[0].values[0].pop_back();
  EXPECT_THROW((void)coverage_json(answer), ContractViolation);
  answer = made_up_answer(DomainType::vertical_profile);
  answer.coverages[0].time.push_back(UtcTime{});
  EXPECT_THROW((void)coverage_json(answer), ContractViolation);
  answer = made_up_answer(DomainType::point, 2);
  answer.coverages[1].domain = DomainType::grid;
  EXPECT_THROW((void)coverage_json(answer), ContractViolation);
}

}  // namespace
}  // namespace slackwater::api::edr::format_coverage_json_test
