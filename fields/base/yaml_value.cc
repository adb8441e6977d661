#include "fields/base/yaml_value.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <utility>

#include "fields/base/text.h"

namespace slackwater {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

/// Whether it may stand without quotes.
bool is_plain(const std::string& word) {
  if (word.empty() || !is_letter(word.front()) || word == "null" || word == "Null" ||
      word == "NULL")
    return false;
  return std::all_of(word.begin(), word.end(),
                     [](char c) { return is_letter(c) || (c >= '0' && c <= '9'); });
}

std::string text_of(const std::string& word) { return is_plain(word) ? word : quoted_yaml(word); }

/// How many lists and mappings lie in one another.
std::size_t depth_of(const YamlValue& value) {
  std::size_t depth = 0;
  for (const YamlValue& item : value.items()) depth = std::max(depth, depth_of(item));
  return value.is_list() || value.is_mapping() ? depth + 1 : 0;
}

/// What is as deep as a task with its waypoints, or the entries of a list, have a line each.
bool is_in_line(const YamlValue& value) {
  constexpr std::size_t deepest = 3;
  return value.is_empty() || depth_of(value) <= deepest;
}

std::string lines_of(const YamlValue& value, std::size_t indent) {
  const std::string before(indent, ' ');
  std::string text;
  for (std::size_t i = 0; i < value.items().size(); ++i) {
    const YamlValue& item = value.items()[i];
    if (value.is_list()) {
      const bool is_entry_in_line = is_in_line(item);
      // The first key of an entry stands behind the dash.
      text +=
          before + "- " +
          (is_entry_in_line ? in_line(item) + "\n" : lines_of(item, indent + 2).substr(indent + 2));
    } else if (is_in_line(item) && !(item.is_list() && depth_of(item) > 1)) {
      text += before + text_of(value.keys()[i]) + ": " + in_line(item) + "\n";
    } else {
      text += before + text_of(value.keys()[i]) + ":\n" + lines_of(item, indent + 2);
    }
  }
  return text;
}

}  // namespace

YamlValue::YamlValue(double number) : kind_(Kind::number), number_(number) {}
YamlValue::YamlValue(std::string word) : kind_(Kind::word), word_(std::move(word)) {}
YamlValue::YamlValue(const char* word) : YamlValue(std::string(word)) {}
YamlValue::YamlValue(bool flag) : YamlValue(flag ? "true" : "false") {}
YamlValue::YamlValue(std::vector<YamlValue> list) : kind_(Kind::list), items_(std::move(list)) {}

YamlValue YamlValue::words(const std::vector<std::string>& words) {
  return std::vector<YamlValue>(words.begin(), words.end());
}

YamlValue YamlValue::numbers(const std::vector<double>& numbers) {
  return std::vector<YamlValue>(numbers.begin(), numbers.end());
}

std::string YamlValue::scalar() const {
  return kind_ == Kind::number ? formatted("{}", number_) : word_;
}

YamlValue& YamlValue::put(std::string_view key, YamlValue value) {
  const auto same = std::find(keys_.begin(), keys_.end(), key);
  if (same != keys_.end()) {
    items_[static_cast<std::size_t>(same - keys_.begin())] = std::move(value);
    return *this;
  }
  keys_.emplace_back(key);
  items_.push_back(std::move(value));
  return *this;
}

std::string yaml_of(const YamlValue& value) {
  return (value.is_list() || value.is_mapping()) && !value.is_empty() ? lines_of(value, 0)
                                                                      : in_line(value) + "\n";
}

std::string in_line(const YamlValue& value) {
  if (!value.is_list() && !value.is_mapping())
    return value.kind_ == YamlValue::Kind::number ? value.scalar() : text_of(value.word_);
  std::string text;
  for (std::size_t i = 0; i < value.items().size(); ++i)
    text += (i > 0 ? ", " : "") +
            (value.is_mapping() ? text_of(value.keys()[i]) + ": " : std::string()) +
            in_line(value.items()[i]);
  return value.is_list() ? "[" + text + "]" : "{" + text + "}";
}

std::string quoted_yaml(const std::string& text) {
  YAML::Emitter out;
  out << YAML::DoubleQuoted << text;
  return out.c_str();
}

}  // namespace slackwater
