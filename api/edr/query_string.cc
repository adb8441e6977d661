#include "api/edr/query_string.h"

#include <algorithm>

#include "api/edr/bad_parameter.h"
#include "api/edr/percent_code.h"

namespace slackwater::api::edr {
namespace {

std::pair<std::string, std::string> pair_of(std::string_view piece) {
  const std::size_t equals = std::min(piece.find('='), piece.size());
  std::string key = percent_decoded("query", piece.substr(0, equals), Plus::is_blank);
  if (key.empty()) throw bad_parameter("query", piece, "a name before '=', as in z=10");
  if (key.find('\0') != std::string::npos) throw bad_parameter("query", piece, "no NUL bytes");
  const std::string_view coded = piece.substr(std::min(equals + 1, piece.size()));
  std::string value = percent_decoded(shown(key), coded, Plus::is_blank);
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
