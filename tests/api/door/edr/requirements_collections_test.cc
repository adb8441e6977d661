// Requirements class "collections" of OGC API-EDR 1.1.
#include <algorithm>
#include <set>

#include "tests/api/door/edr/edr_service_for_tests.h"

namespace slackwater::tests::requirements_collections_test {
namespace {

using nlohmann::json;

const EdrServiceForTests& service() { return edr_service(); }

template <typename Check>
void for_each_collection(const Check& check) {
  const json all = service().document("/collections").at("collections");
  ASSERT_FALSE(all.empty());
  for (const json& collection : all) check(collection);
}

/// The link of each query of each collection, and the name of the query.
template <typename Check>
void for_each_query(const Check& check) {
  for_each_collection([&](const json& collection) {
    for (const auto& [name, query] : collection.at("data_queries").items())
      check(name, query.at("link"), collection);
  });
}

void expect_common_variables(const std::string& name, const json& variables,
                             const json& collection) {
  EXPECT_EQ(variables.at("query_type"), name);
  EXPECT_TRUE(variables.at("title").is_string());
  const json formats = variables.value("output_formats", collection.at("output_formats"));
  for (const json& format : formats) EXPECT_TRUE(format.is_string());
  EXPECT_NE(std::find(formats.begin(), formats.end(), variables.at("default_output_format")),
            formats.end());
  for (const json& crs : variables.at("crs_details")) {
    EXPECT_TRUE(crs.at("crs").is_string());
    EXPECT_TRUE(crs.at("wkt").get<std::string>().starts_with("GEOGCRS["));
  }
}

void expect_units(const json& variables, const char* units) {
  ASSERT_TRUE(variables.contains(units)) << variables;
  EXPECT_FALSE(variables.at(units).empty());
  for (const json& unit : variables.at(units)) EXPECT_TRUE(unit.is_string());
}

TEST(EdrCollections, CollectionsAreListedAtTheirPath) {
  EXPECT_EQ(service().get("/collections").status, 200);
}

TEST(EdrCollections, TheListHasLinksAndCollections) {
  const json list = service().document("/collections");
  EXPECT_EQ(links_with(list, "self"), 1U);
  EXPECT_GE(links_with(list, "alternate"), 1U);
  std::set<std::string> ids;
  for (const json& collection : list.at("collections")) ids.insert(collection.at("id"));
  EXPECT_EQ(ids, (std::set<std::string>{"currents", "currents-members", "wind", "wind-members",
                                        "waves", "sea-level"}));
}

TEST(EdrCollections, EachListedCollectionIsAtItsPath) {
  for_each_collection([](const json& collection) {
    EXPECT_EQ(service().get("/collections/" + collection.at("id").get<std::string>()).status, 200);
  });
}

TEST(EdrCollections, ACollectionSaysOfItselfWhatTheListSays) {
  for_each_collection([](const json& listed) {
    const json alone = service().document("/collections/" + listed.at("id").get<std::string>());
    for (const char* key : {"id", "title", "description", "extent"})
      EXPECT_EQ(alone.at(key), listed.at(key)) << key;
  });
}

TEST(EdrCollections, ACollectionHasAllThatTheStandardWants) {
  for_each_collection([](const json& collection) {
    for (const char* key : {"id", "title", "description", "keywords", "links", "data_queries",
                            "extent", "crs", "output_formats", "parameter_names"})
      EXPECT_TRUE(collection.contains(key)) << key;
  });
}

TEST(EdrCollections, ACollectionLinksToItselfItsPageAndItsQueries) {
  for_each_collection([](const json& collection) {
    EXPECT_EQ(links_with(collection, "self"), 1U);
    EXPECT_GE(links_with(collection, "alternate"), 1U);
    EXPECT_GE(links_with(collection, "data"), 1U);
    for (const json& link : collection.at("links")) {
      if (link.at("rel") != "alternate") continue;
      const std::string path = link.at("href").get<std::string>().substr(15);
      const auto page = service().get_raw(path.substr(0, path.find('?')), "f=html");
      EXPECT_TRUE(page.media_type.starts_with(link.at("type").get<std::string>()));
      EXPECT_TRUE(page.body.starts_with("<!DOCTYPE html>"));
    }
  });
}

TEST(EdrCollections, EveryQueryTypeIsOffered) {
  for_each_collection([](const json& collection) {
    for (const char* name :
         {"position", "radius", "area", "cube", "trajectory", "corridor", "locations", "items"})
      EXPECT_TRUE(collection.at("data_queries").contains(name)) << name;
  });
}

TEST(EdrCollections, EveryQueryHasALinkThatIsServed) {
  for_each_query([](const std::string& name, const json& link, const json&) {
    EXPECT_TRUE(link.contains("rel"));
    EXPECT_TRUE(link.contains("variables"));
    const std::string path = link.at("href").get<std::string>().substr(15);
    const bool is_list = name == "items" || name == "locations";
    EXPECT_EQ(service().get(path).status, is_list ? 200 : 400) << path;
  });
}

TEST(EdrCollections, VariablesNameTheQueryItsFormatsAndSystems) {
  for_each_query([](const std::string& name, const json& link, const json& collection) {
    expect_common_variables(name, link.at("variables"), collection);
  });
}

TEST(EdrCollections, ARadiusQueryListsItsUnits) {
  for_each_query([](const std::string& name, const json& link, const json&) {
    if (name == "radius") expect_units(link.at("variables"), "within_units");
  });
}

TEST(EdrCollections, ACubeQueryListsItsUnits) {
  for_each_query([](const std::string& name, const json& link, const json&) {
    if (name == "cube") expect_units(link.at("variables"), "height_units");
  });
}

TEST(EdrCollections, ACorridorQueryListsItsUnits) {
  for_each_query([](const std::string& name, const json& link, const json&) {
    if (name != "corridor") return;
    expect_units(link.at("variables"), "width_units");
    expect_units(link.at("variables"), "height_units");
  });
}

TEST(EdrCollections, AnItemsQuerySaysThatItIsOne) {
  for_each_query([](const std::string& name, const json& link, const json&) {
    if (name == "items") {
      EXPECT_EQ(link.at("variables").at("query_type"), "items");
    }
  });
}

TEST(EdrCollections, TheExtentHoldsEveryColumnAndTime) {
  for_each_collection([](const json& collection) {
    const json& extent = collection.at("extent");
    const json& box = extent.at("spatial").at("bbox")[0];
    const json& interval = extent.at("temporal").at("interval")[0];
    const json places =
        service().document("/collections/" + collection.at("id").get<std::string>() + "/locations");
    for (const json& feature : places.at("features")) {
      const json& point = feature.at("geometry").at("coordinates");
      EXPECT_LE(box[0], point[0]);
      EXPECT_LE(box[1], point[1]);
      EXPECT_GE(box[2], point[0]);
      EXPECT_GE(box[3], point[1]);
      const std::string times = feature.at("properties").at("datetime");
      EXPECT_LE(interval[0].get<std::string>(), times.substr(0, 20));
      EXPECT_GE(interval[1].get<std::string>(), times.substr(21));
    }
  });
}

TEST(EdrCollections, ACollectionLeadsToQueriesAndInstances) {
  for_each_collection([](const json& collection) {
    EXPECT_GE(links_with(collection, "data"), 1U);
    EXPECT_EQ(links_with(collection, "instance"), 1U);
  });
}

TEST(EdrCollections, EveryCrsHasANameAndAWellKnownText) {
  for_each_query([](const std::string&, const json& link, const json& collection) {
    std::set<std::string> names;
    for (const json& crs : link.at("variables").at("crs_details")) {
      EXPECT_TRUE(names.insert(crs.at("crs")).second);
      const auto wkt = crs.at("wkt").get<std::string>();
      EXPECT_EQ(std::count(wkt.begin(), wkt.end(), '['), std::count(wkt.begin(), wkt.end(), ']'));
      const json& listed = collection.at("crs");
      EXPECT_NE(std::find(listed.begin(), listed.end(), crs.at("crs")), listed.end());
    }
    EXPECT_FALSE(names.empty());
  });
}

TEST(EdrCollections, EveryParameterHasATypeAnObservedPropertyAndAUnit) {
  for_each_collection([](const json& collection) {
    ASSERT_FALSE(collection.at("parameter_names").empty());
    for (const auto& [name, parameter] : collection.at("parameter_names").items()) {
      EXPECT_EQ(parameter.at("type"), "Parameter");
      EXPECT_EQ(parameter.at("id"), name);
      EXPECT_TRUE(parameter.at("observedProperty").at("id").is_string());
      EXPECT_TRUE(parameter.at("observedProperty").at("label").at("en").is_string());
      EXPECT_TRUE(parameter.at("unit").at("label").at("en").is_string());
      EXPECT_EQ(parameter.at("unit").at("symbol").at("type"),
                "http://www.opengis.net/def/uom/UCUM/");
    }
  });
}

}  // namespace
}  // namespace slackwater::tests::requirements_collections_test
