#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/shared_data.h"

// A page of keys beside the readers that ask for them: api/docs/vehicle_file.md, scenario_file.md.

namespace slackwater::tests {

using Words = std::set<std::string, std::less<>>;

/// A file of the tree, by its path from the root.
[[nodiscard]] inline std::string text_of_source(const std::filesystem::path& file) {
  std::ifstream stream(source_folder() / file);
  EXPECT_TRUE(stream.good()) << file;
  return {std::istreambuf_iterator<char>(stream), {}};
}

[[nodiscard]] inline bool is_word(std::string_view text) {
  return !text.empty() && std::isalpha(static_cast<unsigned char>(text.front())) != 0 &&
         std::all_of(text.begin(), text.end(), [](char c) {
           return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
         });
}

/// What stands between two of a mark in a text.
[[nodiscard]] inline std::vector<std::string> between(std::string_view text, char mark) {
  std::vector<std::string> found;
  for (std::size_t at = text.find(mark); at != std::string_view::npos;) {
    const std::size_t end = text.find(mark, at + 1);
    if (end == std::string_view::npos) break;
    found.emplace_back(text.substr(at + 1, end - at - 1));
    at = text.find(mark, end + 1);
  }
  return found;
}

/// The words between quotes in C++, but for its includes and comments.
[[nodiscard]] inline Words words_quoted_in(const std::string& source) {
  Words found;
  std::istringstream lines(source);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#")) continue;
    for (const std::string& quoted : between(line.substr(0, line.find("//")), '"'))
      if (is_word(quoted)) found.insert(quoted);
  }
  return found;
}

/// A section of a page with its subsections. @param heading  "## Tasks"
[[nodiscard]] inline std::string section_of(const std::string& page, const std::string& heading) {
  const std::string line = "\n" + heading + "\n";
  const std::size_t begin = page.find(line);
  EXPECT_NE(begin, std::string::npos) << heading;
  if (begin == std::string::npos) return {};
  std::size_t end = page.find("\n##", begin + line.size());
  const std::size_t level = heading.find(' ');
  while (end != std::string::npos && page.find(' ', end) - end - 1 > level)
    end = page.find("\n##", end + 1);
  return page.substr(begin, end - begin);
}

/// The lines of its tables that have keys: | `a` | unit | ...
[[nodiscard]] inline std::vector<std::string> rows_of_keys(const std::string& section) {
  std::vector<std::string> rows;
  bool has_keys = false;
  std::istringstream lines(section);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("|")) has_keys = false;
    if (has_keys && line.find('`') != std::string::npos) rows.push_back(line);
    if (line.starts_with("| key |")) has_keys = true;
  }
  return rows;
}

/// What the first column of a row names.
[[nodiscard]] inline std::vector<std::string> keys_of_row(const std::string& row) {
  return between(row.substr(0, row.find('|', 1)), '`');
}

[[nodiscard]] inline Words keys_in_tables(const std::string& section) {
  Words keys;
  for (const std::string& row : rows_of_keys(section))
    for (const std::string& key : keys_of_row(row)) keys.insert(key);
  return keys;
}

[[nodiscard]] inline std::string in_one_but_not(const Words& one, const Words& other) {
  std::string all;
  for (const std::string& word : one)
    if (!other.contains(word)) all += (all.empty() ? "" : ", ") + word;
  return all;
}

/// The blocks of YAML of a page.
[[nodiscard]] inline std::vector<std::string> yaml_blocks(const std::string& page) {
  const std::string fence = "```yaml\n";
  std::vector<std::string> blocks;
  for (std::size_t at = page.find(fence); at != std::string::npos; at = page.find(fence, at + 1)) {
    const std::size_t begin = at + fence.size();
    blocks.push_back(page.substr(begin, page.find("\n```", begin) + 1 - begin));
  }
  return blocks;
}

/// The one that begins like that.
[[nodiscard]] inline std::string yaml_block_of(const std::string& page, std::string_view begins) {
  for (const std::string& block : yaml_blocks(page))
    if (block.starts_with(begins)) return block;
  ADD_FAILURE() << "no block begins with: " << begins;
  return {};
}

}  // namespace slackwater::tests
