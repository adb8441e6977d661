#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/shared_data.h"

// Whoever has the tree has what it cites: each page (*.md) that a comment, a message or a page
// names is in the tree, and so is each source (*.h, *.cc) that a comment or a page names. Each page
// for users is reached from the index by links.

namespace slackwater::tests::cited_pages_test {
namespace {

namespace fs = std::filesystem;

/// Pages of other projects that we name as sources.
const std::set<std::string, std::less<>> foreign{"docs/spec.md", "holybro_x500v2_pixhawk6c.md"};

/// Headers of other projects, and one that nobody shall write.
const std::set<std::string, std::less<>> foreign_sources{"netcdf.h", "rmw/types.h", "utils.h"};

/// Names of pages or sources, without their folders.
using Names = std::set<std::string, std::less<>>;

bool in_a_path(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
         std::string_view("_./-:").find(c) != std::string_view::npos;
}

/// What stands in a text as a path with the ending; addresses of the web, absolute paths and
/// patterns (`*_test.cc`, `<parser>_fuzz.cc`) left out.
void add_paths_named_in(std::string_view text, std::string_view ending,
                        std::vector<std::string>& found) {
  for (std::size_t at = text.find(ending); at != std::string_view::npos;
       at = text.find(ending, at + ending.size())) {
    const std::size_t end = at + ending.size();
    if (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) != 0 ||
                              text[end] == '_' || text[end] == '(')) {
      continue;
    }
    std::size_t begin = at;
    while (begin > 0 && in_a_path(text[begin - 1])) --begin;
    const std::string path(text.substr(begin, end - begin));
    const bool is_pattern =
        begin > 0 && std::string_view("*<>{}").find(text[begin - 1]) != std::string_view::npos;
    if (path.front() == '/' || path == ending || is_pattern) continue;
    if (path.find(':') == std::string::npos) found.push_back(path);
  }
}

std::vector<std::string> pages_named_in(std::string_view text) {
  std::vector<std::string> found;
  add_paths_named_in(text, ".md", found);
  return found;
}

/// What a C++ source says in comments; of another file all.
std::string prose_of(const fs::path& file, const std::string& text) {
  if (file.extension() == ".md") return text;
  std::string prose;
  if (file.extension() != ".h" && file.extension() != ".cc") return prose;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t comment = line.find("//");
    if (comment != std::string::npos) prose += line.substr(comment + 2) + "\n";
  }
  return prose;
}

std::vector<std::string> sources_named_in(std::string_view prose) {
  std::vector<std::string> found;
  for (const char* ending : {".h", ".cc"}) add_paths_named_in(prose, ending, found);
  return found;
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(source_folder() / file);
  return {std::istreambuf_iterator<char>(stream), {}};
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
bool is_there(const std::string& page, const fs::path& from, const Names& names) {
  if (fs::exists(source_folder() / page) || foreign.contains(page)) return true;
  if (fs::exists(source_folder() / from.parent_path() / page)) return true;
  if (page.find('/') == std::string::npos) return names.contains(page);
  return page.starts_with("docs/") && fs::exists(source_folder() / "api" / page);
}

/// True where a source is found from the root, beside the file that names it, or (a bare name)
/// somewhere in the tree.
bool is_source_there(const std::string& source, const fs::path& from, const Names& names) {
  if (fs::exists(source_folder() / source) || foreign_sources.contains(source)) return true;
  if (fs::exists(source_folder() / from.parent_path() / source)) return true;
  return source.find('/') == std::string::npos && names.contains(source);
}

TEST(CitedPages, AreInTheTree) {
  const std::vector<fs::path> files = texts();
  Names names;
  for (const fs::path& file : files) {
    if (file.extension() == ".md") names.insert(file.filename().string());
  }
  std::size_t cited = 0;
  for (const fs::path& file : files) {
    if (file.filename() == "cited_pages_test.cc") continue;
    for (const std::string& page : pages_named_in(text_of(file))) {
      ++cited;
      EXPECT_TRUE(is_there(page, file, names)) << file << " names " << page;
    }
  }
  EXPECT_GT(cited, 150U) << "the sources were not found";
}

TEST(CitedPages, CitedSourcesAreInTheTree) {
  const std::vector<fs::path> files = texts();
  Names names;
  for (const fs::path& file : files) {
    if (file.extension() == ".h" || file.extension() == ".cc")
      names.insert(file.filename().string());
  }
  std::size_t cited = 0;
  for (const fs::path& file : files) {
    if (file.filename() == "cited_pages_test.cc") continue;
    for (const std::string& source : sources_named_in(prose_of(file, text_of(file)))) {
      ++cited;
      EXPECT_TRUE(is_source_there(source, file, names)) << file << " names " << source;
    }
  }
  EXPECT_GT(cited, 150U) << "the sources were not found";
}

/// Targets of the links `](PAGE.md)` and `](PAGE.md#SECTION)` of a page, from the root.
std::vector<std::string> linked_from(const std::string& page) {
  const std::string text = text_of(page);
  std::vector<std::string> found;
  for (std::size_t at = text.find("]("); at != std::string::npos; at = text.find("](", at + 2)) {
    const std::string target = text.substr(at + 2, text.find_first_of(")#", at + 2) - at - 2);
    if (!target.ends_with(".md") || target.find("://") != std::string::npos) continue;
    found.push_back((fs::path(page).parent_path() / target).lexically_normal().string());
  }
  return found;
}

TEST(CitedPages, PagesForUsersAreReachedFromTheIndex) {
  Names reached;
  std::vector<std::string> next{"api/docs/index.md"};
  while (!next.empty()) {
    const std::string page = next.back();
    next.pop_back();
    if (!reached.insert(page).second) continue;
    ASSERT_TRUE(fs::exists(source_folder() / page)) << page << " is linked to and not there";
    for (const std::string& target : linked_from(page)) next.push_back(target);
  }
  for (const fs::path& file : texts()) {
    const bool is_for_users = file.extension() == ".md" && !file.string().starts_with("tests/");
    EXPECT_TRUE(!is_for_users || reached.contains(file.string())) << file;
  }
}

TEST(CitedPages, APageOutsideTheTreeIsSeen) {
  const std::vector<std::string> named =
      pages_named_in("see reference/physics.md and https://x.org/a.md, /usr/doc/b.md; x.mdb");
  EXPECT_EQ(named, std::vector<std::string>{"reference/physics.md"});
  EXPECT_FALSE(is_there("reference/physics.md", "fields/README.md", {"physics.md"}));
  EXPECT_FALSE(is_there("INDEX.md", "fields/README.md", {"physics.md"}));
  EXPECT_TRUE(is_there("fields/docs/physics.md", "twin/README.md", {}));
}

TEST(CitedPages, ASourceOutsideTheTreeIsSeen) {
  const std::string text =
      "#include \"a/not_said.h\"\nx.h(); // see a/gone.h, *_test.cc, /usr/b.h\n";
  EXPECT_EQ(sources_named_in(prose_of("a/b.cc", text)), std::vector<std::string>{"a/gone.h"});
  EXPECT_EQ(sources_named_in(prose_of("a/b.md", "`a/b.cc`, x.html")),
            std::vector<std::string>{"a/b.cc"});
  EXPECT_FALSE(is_source_there("a/gone.h", "fields/README.md", {"gone.h"}));
  EXPECT_TRUE(is_source_there("gone.h", "fields/README.md", {"gone.h"}));
  EXPECT_TRUE(is_source_there("fields/grid/status.h", "twin/README.md", {}));
  EXPECT_TRUE(is_source_there("status.h", "fields/grid/axis.h", {}));
}

}  // namespace
}  // namespace slackwater::tests::cited_pages_test
