#include "api/ask/vehicle/scalar_keys.h"

#include <charconv>
#include <cmath>

namespace slackwater::api {
namespace {

/// Also of `-6.10`, which a number would not be written as.
std::optional<double> number_of(const YamlValue& value) {
  if (value.is_list() || value.is_mapping()) return std::nullopt;
  const std::string text = value.scalar();
  const char *begin = text.data(), *const end = begin + text.size();
  if (begin != end && *begin == '+') ++begin;
  double number = 0;
  const auto [stop, problem] = std::from_chars(begin, end, number);
  if (problem != std::errc{} || stop != end || begin == end || !std::isfinite(number))
    return std::nullopt;
  return number;
}

std::string key_of_item(const YamlValue& within, const std::string& above, std::size_t item) {
  if (within.is_list()) return above + "[" + std::to_string(item) + "]";
  return (above.empty() ? "" : above + ".") + within.keys()[item];
}

void note_scalars(const YamlValue& value, const std::string& key, std::vector<ScalarKey>& all) {
  if (const auto number = number_of(value)) all.push_back({key, *number});
  for (std::size_t i = 0; i < value.items().size(); ++i)
    note_scalars(value.items()[i], key_of_item(value, key, i), all);
}

YamlValue changed(const YamlValue& value, const std::string& key, std::string_view wanted,
                  double number) {
  if (key == wanted && number_of(value)) return number;
  if (!wanted.starts_with(key)) return value;
  if (value.is_list()) {
    std::vector<YamlValue> items;
    for (std::size_t i = 0; i < value.items().size(); ++i)
      items.push_back(changed(value.items()[i], key_of_item(value, key, i), wanted, number));
    return items;
  }
  if (!value.is_mapping()) return value;
  YamlValue mapping;
  for (std::size_t i = 0; i < value.items().size(); ++i)
    mapping.put(value.keys()[i],
                changed(value.items()[i], key_of_item(value, key, i), wanted, number));
  return mapping;
}

}  // namespace

std::vector<ScalarKey> scalar_keys(const YamlValue& mapping) {
  std::vector<ScalarKey> all;
  note_scalars(mapping, "", all);
  return all;
}

std::optional<double> number_at(const YamlValue& mapping, std::string_view key) {
  for (const ScalarKey& scalar : scalar_keys(mapping))
    if (scalar.key == key) return scalar.value;
  return std::nullopt;
}

YamlValue with_number(const YamlValue& mapping, std::string_view key, double value) {
  return changed(mapping, "", key, value);
}

}  // namespace slackwater::api
