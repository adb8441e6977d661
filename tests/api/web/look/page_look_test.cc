#include "api/web/look/page_look.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/support/shared_data.h"

// Every page for people has its colours from one file.

namespace slackwater::tests::page_look_test {
namespace {

const char* const palette_file = "api/web/look/palette.css";

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(source_folder() / file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Files of api/ that may hold style, but for the palette itself.
std::vector<std::filesystem::path> files_with_style() {
  const std::set<std::string> endings{".cc", ".h", ".css", ".html", ".in", ".js", ".ts"};
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source_folder() / "api")) {
    const auto file = std::filesystem::relative(entry.path(), source_folder());
    if (endings.contains(file.extension().string()) && file != palette_file) files.push_back(file);
  }
  return files;
}

std::set<std::string> all(const std::string& text, const std::regex& what) {
  std::set<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), what), end; at != end; ++at)
    found.insert((*at)[1]);
  return found;
}

/// What stands between a selector's braces.
std::string rules_of(const std::string& style, const std::string& selector) {
  const std::size_t at = style.find(selector + " {");
  if (at == std::string::npos) return {};
  const std::size_t begin = style.find('{', at) + 1;
  return style.substr(begin, style.find('}', begin) - begin);
}

TEST(PageLook, TheTokensStandInOneFileOnly) {
  const auto tokens = all(text_of(palette_file), std::regex("(--[a-z-]+):"));
  ASSERT_GT(tokens.size(), 25U);
  const auto files = files_with_style();
  ASSERT_GT(files.size(), 300U) << "the sources were not found";
  for (const auto& file : files) {
    const std::string text = text_of(file);
    // Letters on paper are smaller; their colours are those of the day.
    for (const std::string& token : tokens)
      if (!token.starts_with("--text"))
        EXPECT_EQ(text.find(token + ":"), std::string::npos) << token << " " << file;
  }
}

TEST(PageLook, StyleOfPagesNamesNoColourAndNoTokenThatIsNone) {
  const std::string palette = text_of(palette_file);
  for (const char* file : {"api/web/look/parts.css", "api/show/report/page/report.css",
                           "api/door/edr/write/html_frame.cc", "api/web/desk/look/layout.css",
                           "api/web/desk/decide/decide.css"}) {
    const std::string style = text_of(file);
    ASSERT_FALSE(style.empty()) << file;
    EXPECT_TRUE(all(style, std::regex("(#[0-9a-fA-F]{3,8})\\b[^{]*;")).empty()) << file;
    for (const std::string& token : all(style, std::regex("var\\((--[a-z-]+)\\)")))
      EXPECT_NE(palette.find(token + ":"), std::string::npos) << token << " " << file;
  }
}

TEST(PageLook, APageThatIsOneFileHasDayDuskAndNight) {
  const std::string palette = text_of(palette_file);
  const std::string look(web::page_look());
  EXPECT_EQ(rules_of(look, ":root"), rules_of(palette, ":root"));
  for (const char* name : {"dusk", "night"}) {
    const std::string selector = ":root[data-palette='" + std::string(name) + "']";
    ASSERT_NE(rules_of(palette, selector), "") << name;
    EXPECT_EQ(rules_of(look, selector), rules_of(palette, selector)) << name;
  }
  // Where the system is dark and nobody chose, it is dusk; on paper it is never.
  EXPECT_EQ(rules_of(look, ":root:not([data-palette])"),
            rules_of(palette, ":root[data-palette='dusk']"));
  const std::size_t screen = look.find("@media screen {");
  const std::size_t dark = look.find("@media screen and (prefers-color-scheme: dark) {");
  ASSERT_NE(screen, std::string::npos);
  ASSERT_NE(dark, std::string::npos);
  EXPECT_LT(screen, look.find("data-palette"));
  EXPECT_LT(dark, look.find(":not([data-palette])"));
  EXPECT_TRUE(look.ends_with(text_of("api/web/look/parts.css")));
}

TEST(PageLook, EveryPaletteHasEveryColour) {
  const std::string palette = text_of(palette_file);
  const std::regex colour("(--[a-z-]+): #");
  const auto day = all(rules_of(palette, ":root"), colour);
  for (const char* name : {"dusk", "night"}) {
    const std::string selector = ":root[data-palette='" + std::string(name) + "']";
    EXPECT_EQ(all(rules_of(palette, selector), colour), day) << name;
  }
}

}  // namespace
}  // namespace slackwater::tests::page_look_test
