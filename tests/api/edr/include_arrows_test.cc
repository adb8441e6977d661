#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "tests/support/shared_data.h"

// Within the service, who may include what of api: reading, sampling, writing, and the transport
// that knows of none of them.

namespace slackwater::tests {
namespace {

/// What the includes of a folder may begin with.
const std::map<std::string, std::vector<std::string>>& allowed() {
  static const std::map<std::string, std::vector<std::string>> all{
      {"api/edr/read", {"api/edr/read/", "api/http/percent.h"}},
      {"api/edr/sample", {"api/edr/sample/", "api/edr/read/", "api/issued/issued_fields.h"}},
      {"api/edr/write",
       {"api/edr/write/", "api/edr/sample/", "api/edr/read/", "api/issued/issued_fields.h",
        "api/program/version.h", "api/http/percent.h"}},
      {"api/http", {"api/http/"}}};
  return all;
}

bool is_allowed(const std::string& folder, const std::string& line) {
  if (!line.starts_with("#include \"api/")) return true;
  const std::string header = line.substr(10);
  const std::vector<std::string>& beginnings = allowed().at(folder);
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](const std::string& beginning) { return header.starts_with(beginning); });
}

TEST(EdrIncludes, PointFromWritingToSamplingToReadingAndNeverBack) {
  for (const auto& [folder, beginnings] : allowed()) {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(source_folder() / folder)) {
      ++files;
      std::ifstream stream(entry.path());
      for (std::string line; std::getline(stream, line);)
        EXPECT_TRUE(is_allowed(folder, line)) << entry.path() << ": " << line;
    }
    EXPECT_GT(files, 20U) << folder << ": the sources were not found";
  }
}

TEST(EdrIncludes, AForbiddenArrowIsSeen) {
  EXPECT_FALSE(is_allowed("api/http", "#include \"api/pipeline/version.h\""));
  EXPECT_FALSE(is_allowed("api/edr/read", "#include \"api/edr/sample/answer.h\""));
  EXPECT_FALSE(is_allowed("api/edr/sample", "#include \"api/http/message.h\""));
  EXPECT_FALSE(is_allowed("api/edr/write", "#include \"api/edr/service.h\""));
  EXPECT_TRUE(is_allowed("api/edr/write", "#include \"api/edr/sample/answer.h\""));
  EXPECT_TRUE(is_allowed("api/http", "#include \"fields/base/error.h\""));
}

}  // namespace
}  // namespace slackwater::tests
