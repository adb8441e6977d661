// The table requirement -> test is whole, and each conformance class that we declare stands in it.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>

#include "tests/api/door/edr/edr_service_for_tests.h"
#include "tests/support/shared_data.h"

namespace slackwater::tests::requirements_table_test {
namespace {

struct Row {
  std::string conformance_class;
  std::string requirement;
  std::string test;
};

std::vector<Row> table() {
  static const std::regex row(R"(\| ([a-z0-9-]+) \| (/req/\S+) \| (\S+) \|)");
  std::vector<Row> rows;
  std::ifstream stream(source_folder() / "tests/api/door/edr/requirements.md");
  for (std::string line; std::getline(stream, line);) {
    std::smatch parts;
    if (std::regex_match(line, parts, row)) rows.push_back({parts[1], parts[2], parts[3]});
  }
  return rows;
}

/// "Suite.Name" of every test of this program.
std::set<std::string> tests_here() {
  std::set<std::string> names;
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *all.GetTestSuite(i);
    for (int k = 0; k < suite.total_test_count(); ++k)
      names.insert(std::string(suite.name()) + "." + suite.GetTestInfo(k)->name());
  }
  return names;
}

TEST(EdrRequirements, EveryTestOfTheTableExists) {
  const std::set<std::string> tests = tests_here();
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
}  // namespace slackwater::tests::requirements_table_test
