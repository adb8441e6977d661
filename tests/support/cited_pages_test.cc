#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/shared_data.h"

// Whoever has the tree has what it cites: each page (*.md) that a comment, a message or a page
// names is in the tree.

namespace slackwater::tests {
namespace {

namespace fs = std::filesystem;

/// Pages of other projects that we name as sources.
const std::set<std::string, std::less<>> foreign{"docs/spec.md", "holybro_x500v2_pixhawk6c.md"};

bool in_a_path(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
         std::string_view("_./-:").find(c) != std::string_view::npos;
}

/// What stands in a text as the path of a page; addresses of the web and absolute paths left out.
std::vector<std::string> pages_named_in(std::string_view text) {
  std::vector<std::string> found;
  for (std::size_t at = text.find(".md"); at != std::string_view::npos;
       at = text.find(".md", at + 3)) {
    const std::size_t end = at + 3;
    if (end < text.size() && std::isalnum(static_cast<unsigned char>(text[end])) != 0) continue;
    std::size_t begin = at;
    while (begin > 0 && in_a_path(text[begin - 1])) --begin;
    const std::string page(text.substr(begin, end - begin));
    if (page.front() == '/' || page == ".md") continue;
    if (page.find(':') == std::string::npos) found.push_back(page);
  }
  return found;
}

/// The files of the tree that may cite pages, from the root.
std::vector<fs::path> texts() {
  const std::array endings{".h", ".cc", ".md", ".yaml", ".cmake", ".txt", ".py", ".in", ".html"};
  std::vector<fs::path> files{"README.md", "CONTRIBUTING.md", "CHANGELOG.md", "CMakeLists.txt",
                              "Makefile"};
  for (const char* room :
       {"fields", "ingest", "calibration", "twin", "data", "api", "tests", "cmake", "examples"}) {
    for (const auto& entry : fs::recursive_directory_iterator(source_folder() / room)) {
      const std::string ending = entry.path().extension().string();
      if (entry.is_regular_file() && std::ranges::find(endings, ending) != endings.end()) {
        files.push_back(fs::relative(entry.path(), source_folder()));
      }
    }
  }
  return files;
}

/// True where a page is found from the root, from the file that names it, or (a bare name, as
/// messages have it) among the pages of the tree.
bool is_there(const std::string& page, const fs::path& from,
              const std::set<std::string, std::less<>>& names) {
  if (fs::exists(source_folder() / page) || foreign.contains(page)) return true;
  if (fs::exists(source_folder() / from.parent_path() / page)) return true;
  if (page.find('/') == std::string::npos) return names.contains(page);
  return page.starts_with("docs/") && fs::exists(source_folder() / "api" / page);
}

TEST(CitedPages, AreInTheTree) {
  const std::vector<fs::path> files = texts();
  std::set<std::string, std::less<>> names;
  for (const fs::path& file : files) {
    if (file.extension() == ".md") names.insert(file.filename().string());
  }
  std::size_t cited = 0;
  for (const fs::path& file : files) {
    if (file.filename() == "cited_pages_test.cc") continue;
    std::ifstream stream(source_folder() / file);
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    for (const std::string& page : pages_named_in(text)) {
      ++cited;
      EXPECT_TRUE(is_there(page, file, names)) << file << " names " << page;
    }
  }
  EXPECT_GT(cited, 150U) << "the sources were not found";
}

TEST(CitedPages, APageOutsideTheTreeIsSeen) {
  const std::vector<std::string> named =
      pages_named_in("see reference/physics.md and https://x.org/a.md, /usr/doc/b.md; x.mdb");
  EXPECT_EQ(named, std::vector<std::string>{"reference/physics.md"});
  EXPECT_FALSE(is_there("reference/physics.md", "fields/README.md", {"physics.md"}));
  EXPECT_FALSE(is_there("INDEX.md", "fields/README.md", {"physics.md"}));
  EXPECT_TRUE(is_there("fields/docs/physics.md", "twin/README.md", {}));
}

}  // namespace
}  // namespace slackwater::tests
