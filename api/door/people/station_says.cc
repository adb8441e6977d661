#include "api/door/people/station_says.h"

#include <algorithm>
#include <cmath>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/run/printable.h"

namespace slackwater::people {
namespace {

using nlohmann::json;

[[noreturn]] void refuse(const std::string& text) { throw Error(ErrorKind::invalid_input, text); }

std::string found(const json& value) {
  return twin::printable(value.dump(-1, ' ', true, json::error_handler_t::replace), 60);
}

}  // namespace

StationSays::StationSays(std::string_view text) {
  json_ = json::parse(text, nullptr, false);
  if (!json_.is_object())
    refuse("found a message that is no JSON object, expected e.g. {\"do\": \"ask\", \"id\": 1}");
  const auto what = json_.find("do");
  if (what == json_.end() || !what->is_string())
    refuse("found a message without \"do\", expected a word that says what to do");
  what_ = twin::printable(what->get<std::string>(), 40);
  if (const auto id = json_.find("id"); id != json_.end() && id->is_number_integer()) id_ = *id;
}

StationSays::StationSays(json json, std::string what)
    : json_(std::move(json)), what_(std::move(what)) {}

const json& StationSays::at(std::string_view key) const {
  const auto found = json_.find(key);
  if (found == json_.end()) refuse(formatted("{}: found no {}, expected one", what_, key));
  return *found;
}

double StationSays::number(std::string_view key, double low, double high) const {
  const json& value = at(key);
  const double number = value.is_number() ? value.get<double>() : std::nan("");
  if (number >= low && number <= high) return number;
  refuse(formatted("{}: {}: found {}, expected a number from {:g} to {:g}", what_, key,
                   found(value), low, high));
}

std::int64_t StationSays::whole(std::string_view key, std::int64_t low, std::int64_t high) const {
  const json& value = at(key);
  if (value.is_number_integer()) {
    const bool is_huge =
        value.is_number_unsigned() && value.get<std::uint64_t>() > static_cast<std::uint64_t>(high);
    if (!is_huge && value.get<std::int64_t>() >= low && value.get<std::int64_t>() <= high)
      return value.get<std::int64_t>();
  }
  refuse(formatted("{}: {}: found {}, expected a whole number from {} to {}", what_, key,
                   found(value), low, high));
}

std::optional<double> StationSays::number_if(std::string_view key, double low, double high) const {
  const auto value = json_.find(key);
  if (value == json_.end() || value->is_null()) return std::nullopt;
  return number(key, low, high);
}

std::optional<StationSays> StationSays::object_if(std::string_view key) const {
  const auto value = json_.find(key);
  if (value == json_.end() || value->is_null()) return std::nullopt;
  if (!value->is_object())
    refuse(formatted("{}: {}: found {}, expected an object or null", what_, key, found(*value)));
  return StationSays(*value, formatted("{}: {}", what_, key));
}

bool StationSays::flag(std::string_view key, bool otherwise) const {
  const auto value = json_.find(key);
  if (value == json_.end()) return otherwise;
  if (value->is_boolean()) return value->get<bool>();
  refuse(formatted("{}: {}: found {}, expected true or false", what_, key, found(*value)));
}

std::string StationSays::text(std::string_view key, std::size_t most) const {
  const json& value = at(key);
  if (value.is_string()) {
    auto text = value.get<std::string>();
    // What others print on their terminals.
    const bool is_plain = std::none_of(text.begin(), text.end(),
                                       [](unsigned char c) { return c < ' ' || c == 0x7F; });
    if (is_plain && !text.empty() && text.size() <= most) return text;
  }
  refuse(formatted("{}: {}: found {}, expected a text of 1 to {} bytes without control characters",
                   what_, key, found(value), most));
}

std::string StationSays::text_or_empty(std::string_view key, std::size_t most) const {
  const auto value = json_.find(key);
  if (value == json_.end()) return {};
  if (value->is_string() && value->get_ref<const std::string&>().empty()) return {};
  return text(key, most);
}

std::vector<double> StationSays::numbers(std::string_view key, std::size_t most) const {
  const json& value = at(key);
  if (!value.is_array() || value.size() > most)
    refuse(formatted("{}: {}: found {}, expected a list of at most {} numbers", what_, key,
                     found(value), most));
  std::vector<double> numbers;
  for (const json& one : value) {
    if (!one.is_number() || !std::isfinite(one.get<double>()))
      refuse(formatted("{}: {}: found {}, expected numbers", what_, key, found(one)));
    numbers.push_back(one.get<double>());
  }
  return numbers;
}

std::vector<StationSays> StationSays::list(std::string_view key, std::size_t most) const {
  const json& value = at(key);
  if (!value.is_array() || value.size() > most)
    refuse(formatted("{}: {}: found {}, expected a list of at most {}", what_, key, found(value),
                     most));
  std::vector<StationSays> list;
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (!value[i].is_object())
      refuse(formatted("{}: {} {}: found {}, expected an object", what_, key, i, found(value[i])));
    list.push_back(StationSays(value[i], formatted("{}: {} {}", what_, key, i)));
  }
  return list;
}

}  // namespace slackwater::people
