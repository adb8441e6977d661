// Requirements class "instances" of OGC API-EDR 1.1: instances are issued forecasts.
#include <algorithm>

#include "tests/api/door/edr/edr_service_for_tests.h"

namespace slackwater::tests::requirements_instances_test {
namespace {

using nlohmann::json;

const EdrServiceForTests& service() { return edr_service(); }
const std::string instances = "/collections/currents/instances";

json listed_instances() { return service().document(instances).at("instances"); }

const QueryPairs somewhere{{"coords", "POINT(-2.55 48.85)"}, {"z", "5"}};

TEST(EdrInstances, InstancesAreListedAtTheirPathInEveryCollection) {
  for (const char* collection : {"currents", "currents-members", "wind", "wind-members", "waves"})
    EXPECT_EQ(service().get(std::string("/collections/") + collection + "/instances").status, 200);
}

TEST(EdrInstances, TheListHasLinksAndAllIssuedForecasts) {
  const json list = service().document(instances);
  EXPECT_EQ(links_with(list, "self"), 1U);
  ASSERT_EQ(list.at("instances").size(), 4U);
  for (const json& instance : list.at("instances")) {
    for (const char* key :
         {"id", "links", "extent", "data_queries", "crs", "output_formats", "parameter_names"})
      EXPECT_TRUE(instance.contains(key)) << key;
  }
}

TEST(EdrInstances, EachListedInstanceIsAtItsPath) {
  const json list = listed_instances();
  for (const json& instance : list)
    EXPECT_EQ(service().get(instances + "/" + instance.at("id").get<std::string>()).status, 200);
  EXPECT_FALSE(service().refusal(404, instances + "/nothing").empty());
}

TEST(EdrInstances, AnInstanceSaysOfItselfWhatTheListSays) {
  const json list = listed_instances();
  for (const json& listed : list) {
    const json alone = service().document(instances + "/" + listed.at("id").get<std::string>());
    for (const char* key : {"id", "title", "description", "extent"})
      EXPECT_EQ(alone.at(key), listed.at(key)) << key;
  }
}

TEST(EdrInstances, EveryQueryOfAnInstanceIsServed) {
  const json instance = service().document(instances + "/" + EdrServiceForTests::older);
  for (const auto& [name, query] : instance.at("data_queries").items()) {
    const std::string path = query.at("link").at("href").get<std::string>().substr(15);
    EXPECT_EQ(service().get(path).status, name == "locations" ? 200 : 400) << path;
  }
}

TEST(EdrInstances, AnInstanceAnswersFromItsOwnForecast) {
  for (const char* name : {EdrServiceForTests::older, EdrServiceForTests::newer}) {
    const json body = service().document(instances + "/" + name + "/locations/lone", {{"z", "5"}});
    EXPECT_EQ(body.at("slackwater:provenance").at("instance"), name);
    const auto field = service().field(name);
    const std::vector<double> values = values_of(body, east_current);
    ASSERT_EQ(values.size(), field->snapshot().time.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto sample = field->current({-2.55, 48.85, 5, field->snapshot().time[i]});
      EXPECT_NEAR(values[i], sample.velocity_m_s.real(), 5e-6);
    }
  }
}

TEST(EdrInstances, ACollectionAnswersFromTheNewestForecast) {
  const json body = service().document("/collections/currents/position", somewhere);
  EXPECT_EQ(body.at("slackwater:provenance").at("instance"), EdrServiceForTests::newer);
}

TEST(EdrInstances, InstancesNeverChangeAndTheOneInForceIsReplaced) {
  EdrServiceForTests own;
  const std::string position = "/position";
  const std::string older = instances + "/" + EdrServiceForTests::older + position;
  const std::string newer = instances + "/" + EdrServiceForTests::newer + position;
  const std::string before_older = own.get(older, somewhere).body;
  const std::string before_newer = own.get(newer, somewhere).body;
  own.issue(lone_forecast(2, 13));
  const json now = own.document("/collections/currents/position", somewhere);
  EXPECT_EQ(now.at("slackwater:provenance").at("instance"), "lone_20250312T050000Z");
  EXPECT_EQ(own.get(older, somewhere).body, before_older);
  EXPECT_EQ(own.get(newer, somewhere).body, before_newer);
  EXPECT_EQ(own.document(instances).at("instances").size(), 5U);
}

TEST(EdrInstances, CachesMayKeepAnInstanceLongAndTheForecastInForceShortly) {
  const auto in_force = service().get("/collections/currents/position", somewhere);
  const auto issued =
      service().get(instances + "/" + EdrServiceForTests::older + "/position", somewhere);
  ASSERT_TRUE(in_force.max_age_s && issued.max_age_s);
  EXPECT_LE(*in_force.max_age_s, 60);
  EXPECT_GE(*issued.max_age_s, 3600);
}

}  // namespace
}  // namespace slackwater::tests::requirements_instances_test
