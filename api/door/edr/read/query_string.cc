#include "api/door/edr/read/query_string.h"

#include <algorithm>

#include "api/door/edr/read/bad_parameter.h"
#include "fields/base/encode/percent.h"

namespace slackwater::api::edr {
namespace {

/// In a query '+' stands for a blank (the form encoding).
std::string decoded(std::string_view name, std::string_view text) {
  std::string with_blanks(text);
  std::replace(with_blanks.begin(), with_blanks.end(), '+', ' ');
  auto read = percent_decoded(with_blanks);
  if (!read) {
    throw bad_parameter(name, text,
                        "two hexadecimal digits after '%', as in %20; write a '%' itself as %25");
  }
  return std::move(*read);
}

std::pair<std::string, std::string> pair_of(std::string_view piece) {
  const std::size_t equals = std::min(piece.find('='), piece.size());
  std::string key = decoded("query", piece.substr(0, equals));
  if (key.empty()) throw bad_parameter("query", piece, "a name before '=', as in z=10");
  if (key.find('\0') != std::string::npos) throw bad_parameter("query", piece, "no NUL bytes");
  const std::string_view coded = piece.substr(std::min(equals + 1, piece.size()));
  std::string value = decoded(shown(key), coded);
  if (value.find('\0') != std::string::npos) {
    throw bad_parameter(shown(key), value, "no NUL bytes");
  }
  return {std::move(key), std::move(value)};
}

}  // namespace

QueryString QueryString::parse(std::string_view query) {
  expect_short("query", query, max_query_bytes);
  QueryString read;
  while (!query.empty()) {
    const std::size_t end = std::min(query.find('&'), query.size());
    const std::string_view piece = query.substr(0, end);
    query.remove_prefix(std::min(end + 1, query.size()));
    if (piece.empty()) continue;
    if (read.all_.size() == max_query_parameters) {
      throw bad_parameter("query", piece,
                          "at most " + std::to_string(max_query_parameters) + " parameters");
    }
    auto [key, value] = pair_of(piece);
    if (read.find(key)) {
      throw bad_parameter(shown(key), value,
                          "this parameter once, but it is given again; where it takes a list, "
                          "separate the values by commas");
    }
    read.all_.emplace_back(std::move(key), std::move(value));
  }
  return read;
}

std::optional<std::string_view> QueryString::find(std::string_view key) const noexcept {
  for (const auto& [name, value] : all_) {
    if (name == key) return value;
  }
  return std::nullopt;
}

}  // namespace slackwater::api::edr
