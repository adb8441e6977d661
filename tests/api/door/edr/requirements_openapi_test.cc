// Requirements class "oas30" of OGC API-EDR 1.1.
#include <algorithm>
#include <set>

#include "tests/api/door/edr/edr_service_for_tests.h"

namespace slackwater::tests::requirements_openapi_test {
namespace {

using nlohmann::json;

const EdrServiceForTests& service() { return edr_service(); }

/// Calls `check` with every object of a document.
template <typename Check>
void for_each_object(const json& value, const Check& check) {
  if (value.is_object()) check(value);
  if (value.is_structured())
    for (const json& member : value) for_each_object(member, check);
}

/// A path with names in place of its parameters.
std::string filled(std::string path) {
  for (const auto& [name, value] : {std::pair{"{collectionId}", "currents"},
                                    {"{instanceId}", EdrServiceForTests::older},
                                    {"{itemId}", EdrServiceForTests::older},
                                    {"{locationId}", "lone"}}) {
    const std::size_t at = path.find(name);
    if (at != std::string::npos) path.replace(at, std::string(name).size(), value);
  }
  return path;
}

TEST(EdrOpenApi, TheDefinitionDescribesEveryPathThatIsServed) {
  const json paths = service().document("/api").at("paths");
  for (const auto& [path, operations] : paths.items()) {
    const int status = service().get(filled(path)).status;
    EXPECT_TRUE(status == 200 || status == 400) << path << " " << status;
  }
  for (const char* query : {"position", "radius", "area", "cube", "trajectory", "corridor"}) {
    for (const char* at :
         {"/collections/{collectionId}/", "/collections/{collectionId}/instances/{instanceId}/"})
      EXPECT_TRUE(paths.contains(std::string(at) + query)) << at << query;
  }
}

TEST(EdrOpenApi, TheLandingPageLinksToTheDefinitionForMachinesAndForPeople) {
  const json page = service().document("/");
  std::set<std::pair<std::string, std::string>> links;
  for (const json& link : page.at("links")) links.emplace(link.at("rel"), link.at("type"));
  EXPECT_TRUE(links.contains({"service-desc", "application/vnd.oai.openapi+json;version=3.0"}));
  EXPECT_TRUE(links.contains({"service-doc", "text/html"}));
  const auto people = service().get("/api", {{"f", "html"}});
  EXPECT_EQ(people.media_type, "text/html; charset=utf-8");
  EXPECT_NE(people.body.find("/collections/{collectionId}/position"), std::string::npos);
}

TEST(EdrOpenApi, TheDefinitionIsOpenApi3AndItsReferencesHold) {
  const json definition = service().document("/api");
  EXPECT_EQ(definition.at("openapi"), "3.0.3");
  for_each_object(definition, [&](const json& object) {
    const auto reference = object.find("$ref");
    if (reference == object.end()) return;
    const auto text = reference->get<std::string>();
    ASSERT_TRUE(text.starts_with("#/"));
    EXPECT_TRUE(definition.contains(json::json_pointer(text.substr(1)))) << text;
  });
  std::set<std::string> ids;
  for (const json& operations : definition.at("paths"))
    EXPECT_TRUE(ids.insert(operations.at("get").at("operationId")).second);
}

TEST(EdrOpenApi, EveryOperationSaysEveryStatusThatItMayHave) {
  const json definition = service().document("/api");
  for (const auto& [path, operations] : definition.at("paths").items()) {
    const json& responses = operations.at("get").at("responses");
    for (const char* status :
         {"200", "304", "400", "404", "405", "408", "413", "414", "431", "500", "503"})
      EXPECT_TRUE(responses.contains(status)) << path << " " << status;
  }
}

TEST(EdrOpenApi, EveryRefusalIsDescribedAsAProblemDocument) {
  const json responses = service().document("/api").at("components").at("responses");
  for (const auto& [name, response] : responses.items()) {
    if (name[0] != '4' && name[0] != '5') continue;
    EXPECT_TRUE(response.at("content").contains("application/problem+json")) << name;
  }
  const json body = json::parse(service().get("/collections/soup").body);
  EXPECT_EQ(body.at("status"), 404);
  EXPECT_EQ(body.at("title"), "Not Found");
}

TEST(EdrOpenApi, NothingIsAccessControlledAndTheDefinitionSaysSo) {
  const json definition = service().document("/api");
  EXPECT_FALSE(definition.contains("security"));
  EXPECT_NE(definition.at("info").at("description").get<std::string>().find("access-controlled"),
            std::string::npos);
  for (const auto& [path, operations] : definition.at("paths").items()) {
    EXPECT_EQ(operations.size(), 1U) << "only GET: " << path;
    EXPECT_FALSE(operations.at("get").at("responses").contains("401")) << path;
  }
}

TEST(EdrOpenApi, ExamplesOfTheDefinitionAreAnswered) {
  const json definition = service().document("/api");
  for (const auto& [path, operations] : definition.at("paths").items()) {
    if (path.find("instances/") != std::string::npos) continue;
    std::string at = path;
    QueryPairs query;
    for (json parameter : operations.at("get").at("parameters")) {
      if (parameter.contains("$ref")) {
        parameter =
            definition.at(json::json_pointer(parameter.at("$ref").get<std::string>().substr(1)));
      }
      const auto name = parameter.at("name").get<std::string>();
      const json& example = parameter.at("example");
      if (parameter.at("in") == "path") {
        at.replace(at.find("{" + name + "}"), name.size() + 2, example.get<std::string>());
      } else if (parameter.at("required")) {
        std::string text = example.is_string() ? example.get<std::string>() : example.dump();
        std::erase_if(text, [](char c) { return c == '[' || c == ']'; });
        query.emplace_back(name, text);
      }
    }
    if (path.ends_with("/cube")) query.emplace_back("z", "10");
    EXPECT_EQ(service().get(at, query).status, 200) << at << service().get(at, query).body;
  }
}

}  // namespace
}  // namespace slackwater::tests::requirements_openapi_test
