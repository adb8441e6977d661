// The table requirement -> test is whole, and each conformance class that we declare stands in it.
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/api/edr/edr_service_for_tests.h"
#include "tests/support/shared_data.h"

namespace slackwater::tests {
namespace {

struct Row {
  std::string conformance_class;
  std::string requirement;
  std::string test;
};

std::filesystem::path here() { return source_folder() / "tests/api/edr"; }

std::vector<Row> table() {
  static const std::regex row(R"(\| ([a-z0-9-]+) \| (/req/\S+) \| (\S+) \|)");
  std::vector<Row> rows;
  std::ifstream stream(here() / "requirements.md");
  for (std::string line; std::getline(stream, line);) {
    std::smatch parts;
    if (std::regex_match(line, parts, row)) rows.push_back({parts[1], parts[2], parts[3]});
  }
  return rows;
}

/// "Suite.Name" of every test of this folder.
std::set<std::string> tests_here() {
  static const std::regex test(R"(TEST(?:_F)?\((\w+),\s*(\w+)\))");
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(here())) {
    if (entry.path().extension() != ".cc") continue;
    std::stringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    const std::string source = text.str();
    for (std::sregex_iterator i(source.begin(), source.end(), test), end; i != end; ++i)
      names.insert((*i)[1].str() + "." + (*i)[2].str());
  }
  return names;
}

TEST(EdrRequirements, EveryTestOfTheTableExists) {
  const std::set<std::string> tests = tests_here();
  ASSERT_GT(tests.size(), 100U);
  for (const Row& row : table()) EXPECT_TRUE(tests.contains(row.test)) << row.test;
}

TEST(EdrRequirements, EveryRequirementOfADeclaredClassHasItsRow) {
  // How many the standard's requirements classes hold (OGC 19-086r6).
  const std::map<std::string, std::size_t> whole{
      {"core", 41},   {"collections", 17}, {"queries", 12}, {"instances", 4}, {"json", 2},
      {"geojson", 2}, {"edr-geojson", 2},  {"covjson", 2},  {"oas30", 6}};
  std::map<std::string, std::set<std::string>> held;
  for (const Row& row : table()) {
    EXPECT_TRUE(held[row.conformance_class].insert(row.requirement).second)
        << row.requirement << " stands twice";
  }
  const std::string prefix = "http://www.opengis.net/spec/ogcapi-edr-1/1.1/conf/";
  std::set<std::string> declared;
  const nlohmann::json classes = edr_service().document("/conformance").at("conformsTo");
  for (const nlohmann::json& each : classes) {
    const auto name = each.get<std::string>();
    if (name.starts_with(prefix)) declared.insert(name.substr(prefix.size()));
  }
  for (const std::string& name : declared) {
    ASSERT_TRUE(whole.contains(name)) << name;
    EXPECT_EQ(held[name].size(), whole.at(name)) << name;
  }
  for (const auto& [name, requirements] : held) EXPECT_TRUE(declared.contains(name)) << name;
}

}  // namespace
}  // namespace slackwater::tests
