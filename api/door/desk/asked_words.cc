#include "api/door/desk/asked_words.h"

#include <algorithm>

#include "api/door/edr/read/bad_parameter.h"
#include "api/door/edr/read/number.h"
#include "api/door/edr/read/query_string.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::api::desk {
namespace {

using edr::bad_parameter;
using edr::QueryString;

/// Of one query: longer ones are nobody's.
constexpr std::size_t most_words = 256;

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> pieces{""};
  for (const char c : text) {
    if (c == at)
      pieces.emplace_back();
    else
      pieces.back() += c;
  }
  return pieces;
}

std::string chosen(const AskedWords& words, std::string_view name, std::string_view otherwise,
                   std::initializer_list<std::string_view> possible) {
  std::string said = words.one(name);
  if (said.empty()) return std::string(otherwise);
  if (std::find(possible.begin(), possible.end(), said) == possible.end()) {
    std::vector<std::string> list(possible.begin(), possible.end());
    throw bad_parameter(name, said, joined(list, " or "));
  }
  return said;
}

}  // namespace

double number_in(std::string_view name, const std::string& text, double least, double most) {
  const auto value = edr::number_of(text);
  if (!value || !(*value >= least && *value <= most))
    throw bad_parameter(name, text, formatted("a number from {:g} to {:g}", least, most));
  return *value;
}

AskedWords::AskedWords(const std::string& query, std::initializer_list<std::string_view> known) {
  edr::expect_short("query", query, edr::max_query_bytes);
  for (const std::string& piece : split(query, '&')) {
    const QueryString parsed = QueryString::parse(piece);
    for (const auto& word : parsed.all()) {
      if (std::find(known.begin(), known.end(), word.first) == known.end()) {
        const std::vector<std::string> list(known.begin(), known.end());
        throw bad_parameter("query", word.first,
                            list.empty() ? "no parameter" : "one of " + joined(list, ", "));
      }
      said_.push_back(word);
      if (said_.size() > most_words)
        throw bad_parameter("query", std::to_string(said_.size()) + " parameters",
                            "at most " + std::to_string(most_words));
    }
  }
}

std::string AskedWords::one(std::string_view name) const {
  std::string found;
  bool is_said = false;
  for (const auto& [word, value] : said_) {
    if (word != name) continue;
    if (is_said || value.empty())
      throw bad_parameter(name, value, is_said ? "it once" : "a value, or no " + std::string(name));
    is_said = true;
    found = value;
  }
  return found;
}

std::vector<std::string> AskedWords::all(std::string_view name) const {
  std::vector<std::string> found;
  for (const auto& [word, value] : said_)
    if (word == name)
      for (std::string& piece : split(value, ',')) {
        if (piece.empty()) throw bad_parameter(name, value, "values with commas between them");
        found.push_back(std::move(piece));
      }
  return found;
}

double AskedWords::number(std::string_view name, double least, double most,
                          double otherwise) const {
  const std::string said = one(name);
  return said.empty() ? otherwise : number_in(name, said, least, most);
}

std::size_t AskedWords::count(std::string_view name, std::size_t most,
                              std::size_t otherwise) const {
  const std::string said = one(name);
  if (said.empty()) return otherwise;
  const auto value = edr::count_of(said);
  if (!value || *value < 1 || *value > most)
    throw bad_parameter(name, said, formatted("a whole number from 1 to {}", most));
  return *value;
}

void expect_id(std::string_view what, const std::string& id) {
  const bool is_plain = std::all_of(id.begin(), id.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  });
  if (id.empty() || id.size() > 64 || !is_plain)
    throw bad_parameter(what, id, "an id of letters, digits, '_' and '-'");
}

WindowsWords windows_words(const std::string& site, const std::string& query) {
  const AskedWords words(
      query, {"day", "task", "turbine", "from", "to", "every", "contingency", "members", "waves",
              "assume", "light", "shift", "timezone", "alpha-from", "go", "marginal"});
  WindowsWords asked;
  asked.site = site;
  asked.day = words.one("day");
  asked.tasks = words.all("task");
  for (const std::string& task : asked.tasks) expect_id("task", task);
  asked.turbines = words.all("turbine");
  for (const std::string& turbine : asked.turbines) expect_id("turbine", turbine);
  asked.from = words.one("from");
  asked.to = words.one("to");
  if (const std::string every = words.one("every"); !every.empty()) asked.every = every;
  asked.contingency = words.one("contingency");
  asked.members = words.count("members", 1000, 0);
  asked.waves = chosen(words, "waves", asked.waves, {"error", "forecast"});
  asked.assume = words.all("assume");
  asked.light = words.one("light");
  asked.shift = words.one("shift");
  asked.zone = words.one("timezone");
  asked.period_from = chosen(words, "alpha-from", asked.period_from, {"issue", "start"});
  asked.go = words.number("go", 0, 1, asked.go);
  asked.marginal = words.number("marginal", 0, 1, asked.marginal);
  return asked;
}

}  // namespace slackwater::api::desk
