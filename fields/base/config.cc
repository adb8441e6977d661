#include "fields/base/config.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "fields/base/advice.h"
#include "fields/base/check.h"
#include "fields/base/error.h"
#include "fields/base/given_file.h"
#include "fields/base/text.h"

namespace slackwater {
namespace {

constexpr std::size_t largest_file = 4U << 20U;
constexpr int deepest_nesting = 64;
constexpr std::size_t most_nodes = 200000;

/// Refuses documents that would cost too much to walk: aliases can make small files huge.
void limit_size(const YAML::Node& node, int depth, std::size_t& count, const std::string& name) {
  if (depth > deepest_nesting || ++count > most_nodes) {
    throw Error(
        ErrorKind::invalid_input,
        name + ": nested deeper than 64 levels or longer than 200000 nodes; write a plain file");
  }
  if (node.IsMap()) {
    for (const auto& entry : node) {
      if (!entry.first.IsScalar()) {
        throw Error(ErrorKind::invalid_input,
                    name + ":" + std::to_string(entry.first.Mark().line + 1) +
                        ": found a key that is not a word; write `key: value`");
      }
      limit_size(entry.second, depth + 1, count, name);
    }
  } else if (node.IsSequence()) {
    for (const auto& entry : node) limit_size(entry, depth + 1, count, name);
  }
}

YamlValue value_of(const YAML::Node& node) {
  if (node.IsScalar()) {
    const std::string& word = node.Scalar();
    double number = 0;
    const bool is_quoted = node.Tag() == "!";
    if (!is_quoted && YAML::convert<double>::decode(node, number) &&
        YamlValue(number).scalar() == word)
      return number;
    return word;
  }
  if (node.IsSequence()) {
    std::vector<YamlValue> list;
    for (const auto& entry : node) list.push_back(value_of(entry));
    return list;
  }
  YamlValue mapping;
  for (const auto& entry : node) {
    const std::string& key = entry.first.Scalar();
    const std::vector<std::string>& had = mapping.keys();
    if (std::find(had.begin(), had.end(), key) != had.end())
      refuse("line " + std::to_string(entry.first.Mark().line + 1) + ": found '" + key +
             "' twice in one mapping; keep one");
    if (!entry.second.IsNull()) mapping.put(key, value_of(entry.second));
  }
  return mapping;
}

YAML::Node node_of(const YamlValue& value) {
  if (value.is_mapping()) {
    YAML::Node node(YAML::NodeType::Map);
    for (std::size_t i = 0; i < value.items().size(); ++i)
      node.force_insert(value.keys()[i], node_of(value.items()[i]));
    return node;
  }
  if (value.is_list()) {
    YAML::Node node(YAML::NodeType::Sequence);
    for (const YamlValue& item : value.items()) node.push_back(node_of(item));
    return node;
  }
  return YAML::Node(value.scalar());
}

/// yaml-cpp recurses once per bracket while it parses, so deep flow nesting is refused before it
/// sees the text.
void limit_brackets(std::string_view yaml, const std::string& name) {
  int depth = 0;
  int dashes = 0;
  for (const char c : yaml) {
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') depth = std::max(0, depth - 1);
    // "- - - -" and "? ? ?" also nest without brackets.
    dashes = (c == '-' || c == '?' || c == ' ' || c == ':') ? dashes + (c == ' ' ? 0 : 1) : 0;
    if (depth > deepest_nesting || dashes > deepest_nesting) {
      throw Error(ErrorKind::invalid_input,
                  name + ": nested deeper than 64 levels; write a plain file");
    }
  }
}

/// What has no line was never in a file.
void note_places(const YAML::Node& node, const std::string& above, KeyPlaces& places) {
  const auto note = [&](const std::string& key, const YAML::Node& marked, const YAML::Node& value) {
    if (!marked.Mark().is_null()) places.line.emplace(key, marked.Mark().line + 1);
    note_places(value, key, places);
  };
  if (node.IsMap()) {
    for (const auto& entry : node)
      note((above.empty() ? "" : above + ".") + entry.first.Scalar(), entry.first, entry.second);
  } else if (node.IsSequence()) {
    std::size_t i = 0;
    for (const auto& entry : node) note(above + "[" + std::to_string(i++) + "]", entry, entry);
  }
}

std::string plain(double value) { return formatted("{:g}", value); }

}  // namespace

struct Config::Node {
  YAML::Node yaml;
  std::string file;
  std::string path;  ///< dotted keys above, for messages
  std::map<std::string, YAML::Node, std::less<>> entries;
  std::vector<std::string> order;
  std::set<std::string, std::less<>> asked;
  std::vector<std::shared_ptr<Node>> children;
  std::map<std::string, std::shared_ptr<Node>, std::less<>> child_of;
  std::map<std::string, std::shared_ptr<Node>, std::less<>> home_of;  ///< of what was merged in

  Node(const YAML::Node& node, std::string file_name, std::string above)
      : yaml(node), file(std::move(file_name)), path(std::move(above)) {
    if (!yaml.IsMap()) {
      throw Error(ErrorKind::invalid_input, where(yaml) + (path.empty() ? "" : path + ": ") +
                                                "found " + shape(yaml) +
                                                " where a mapping (key: value) was expected");
    }
    for (const auto& entry : yaml) {
      const std::string key = entry.first.Scalar();
      if (entries.contains(key)) {
        throw Error(ErrorKind::invalid_input,
                    where(entry.first) + "key '" + key + "' is there twice; keep one");
      }
      entries.emplace(key, entry.second);
      order.push_back(key);
    }
  }

  static std::string shape(const YAML::Node& node) {
    if (node.IsMap()) return "a mapping";
    if (node.IsSequence()) return "a list";
    if (node.IsScalar()) return "'" + node.Scalar() + "'";
    return "nothing";
  }
  /// What has no line was never in a file.
  std::string where(const YAML::Node& node) const {
    return file + (node.Mark().is_null() ? "" : ":" + std::to_string(node.Mark().line + 1)) + ": ";
  }
  /// The mapping that a key was written in.
  const Node& home(std::string_view key) const {
    const auto merged_in = home_of.find(key);
    return merged_in == home_of.end() ? *this : *merged_in->second;
  }
  std::string dotted(std::string_view key) const {
    if (const Node& other = home(key); &other != this) return other.dotted(key);
    return path.empty() ? std::string(key) : path + "." + std::string(key);
  }
  const YAML::Node* find(std::string_view key) {
    asked.emplace(key);
    const auto found = entries.find(key);
    if (found == entries.end() || found->second.IsNull()) return nullptr;
    return &found->second;
  }
  const YAML::Node& get(std::string_view key) {
    if (const YAML::Node* node = find(key)) return *node;
    throw Error(ErrorKind::invalid_input,
                where(yaml) + "key '" + dotted(key) + "' is missing; add it");
  }
  [[noreturn]] void refuse(std::string_view key, const YAML::Node& node,
                           std::string_view why) const {
    throw Error(ErrorKind::invalid_input,
                home(key).where(node) + dotted(key) + ": " + std::string(why));
  }
  double number(std::string_view key, const YAML::Node& node, Range range) const {
    double value = 0;
    if (!node.IsScalar() || !YAML::convert<double>::decode(node, value)) {
      const auto meant = node.IsScalar() ? with_decimal_point(node.Scalar()) : std::nullopt;
      refuse(key, node,
             "found " + shape(node) + " where a number was expected" +
                 (meant ? "; use a decimal point: write " + *meant : ""));
    }
    if (!(value >= range.low && value <= range.high)) {
      refuse(key, node,
             "found " + node.Scalar() + ", expected a value from " + plain(range.low) + " to " +
                 plain(range.high) + "; check the unit in the key's name");
    }
    return value;
  }
  std::string scalar(std::string_view key, const YAML::Node& node) const {
    if (!node.IsScalar()) refuse(key, node, "found " + shape(node) + " where a word was expected");
    return node.Scalar();
  }
};

Config Config::parse(std::string_view yaml, std::string_view name) {
  const std::string file(name);
  if (yaml.size() > largest_file) {
    throw Error(ErrorKind::invalid_input,
                file + ": longer than 4 MiB; this is not a configuration file");
  }
  limit_brackets(yaml, file);
  try {
    const YAML::Node root = YAML::Load(std::string(yaml));
    std::size_t count = 0;
    limit_size(root, 0, count, file);
    return Config(std::make_shared<Node>(root, file, ""));
  } catch (const YAML::Exception& problem) {
    throw Error(ErrorKind::invalid_input, file + ":" + std::to_string(problem.mark.line + 1) +
                                              ": not valid YAML: " + problem.msg);
  }
}

Config Config::of(const YamlValue& mapping, std::string_view name) {
  return Config(std::make_shared<Node>(node_of(mapping), std::string(name), ""));
}

Config Config::merged_over(const Config& base, const std::set<std::string>& left_out) const {
  expects(node_->home_of.empty(), "what was merged over another is not merged again");
  auto merged = std::make_shared<Node>(node_->yaml, node_->file, node_->path);
  for (const std::string& key : left_out) {
    merged->entries.erase(key);
    std::erase(merged->order, key);
  }
  for (const std::string& key : merged->order) node_->asked.insert(key);
  for (const std::string& key : base.keys()) {
    if (merged->entries.contains(key) || left_out.contains(key)) continue;
    merged->entries.emplace(key, base.node_->entries.at(key));
    merged->order.push_back(key);
    merged->home_of.emplace(key, base.node_);
  }
  return Config(merged);
}

Config Config::load(const std::filesystem::path& file) {
  return parse(text_of_given_file(file, "a YAML file", largest_file), file.string());
}

bool Config::has(std::string_view key) const { return node_->find(key) != nullptr; }

double Config::number(std::string_view key, Range range) const {
  return node_->number(key, node_->get(key), range);
}

std::optional<double> Config::optional_number(std::string_view key, Range range) const {
  const YAML::Node* node = node_->find(key);
  if (node == nullptr) return std::nullopt;
  return node_->number(key, *node, range);
}

int Config::integer(std::string_view key, int low, int high) const {
  const double value = number(key, {static_cast<double>(low), static_cast<double>(high)});
  if (value != std::floor(value)) {
    node_->refuse(key, node_->get(key), "found a fraction where a whole number was expected");
  }
  return static_cast<int>(value);
}

std::optional<int> Config::optional_integer(std::string_view key, int low, int high) const {
  if (!has(key)) return std::nullopt;
  return integer(key, low, high);
}

std::string Config::text(std::string_view key) const { return node_->scalar(key, node_->get(key)); }

std::optional<std::string> Config::optional_text(std::string_view key) const {
  const YAML::Node* node = node_->find(key);
  if (node == nullptr) return std::nullopt;
  return node_->scalar(key, *node);
}

std::optional<bool> Config::optional_flag(std::string_view key) const {
  const YAML::Node* node = node_->find(key);
  if (node == nullptr) return std::nullopt;
  const std::string word = node_->scalar(key, *node);
  if (word == "true") return true;
  if (word == "false") return false;
  node_->refuse(key, *node, "found '" + word + "', expected true or false");
}

std::vector<std::string> Config::texts(std::string_view key) const {
  const YAML::Node* node = node_->find(key);
  std::vector<std::string> result;
  if (node == nullptr) return result;
  if (node->IsScalar()) return {node->Scalar()};
  if (!node->IsSequence()) node_->refuse(key, *node, "found a mapping where a list was expected");
  for (const auto& entry : *node) result.push_back(node_->scalar(key, entry));
  return result;
}

std::vector<double> Config::numbers(std::string_view key, Range range) const {
  const YAML::Node* node = node_->find(key);
  std::vector<double> result;
  if (node == nullptr) return result;
  if (!node->IsSequence()) return {node_->number(key, *node, range)};
  for (const auto& entry : *node) result.push_back(node_->number(key, entry, range));
  return result;
}

std::optional<Config> Config::optional_child(std::string_view key) const {
  const YAML::Node* node = node_->find(key);
  if (node == nullptr) return std::nullopt;
  if (const auto known = node_->child_of.find(key); known != node_->child_of.end()) {
    return Config(known->second);
  }
  auto child = std::make_shared<Node>(*node, node_->home(key).file, node_->dotted(key));
  node_->children.push_back(child);
  node_->child_of.emplace(std::string(key), child);
  return Config(child);
}

Config Config::child(std::string_view key) const {
  static_cast<void>(node_->get(key));
  return *optional_child(key);
}

std::vector<Config> Config::children(std::string_view key) const {
  const YAML::Node* node = node_->find(key);
  std::vector<Config> result;
  if (node == nullptr) return result;
  if (!node->IsSequence())
    node_->refuse(key, *node, "found " + Node::shape(*node) + " where a list was expected");
  std::size_t index = 0;
  for (const auto& entry : *node) {
    auto child = std::make_shared<Node>(entry, node_->home(key).file,
                                        node_->dotted(key) + "[" + std::to_string(index++) + "]");
    node_->children.push_back(child);
    result.push_back(Config(child));
  }
  return result;
}

bool Config::is_list(std::string_view key) const {
  const YAML::Node* node = node_->find(key);
  return node != nullptr && node->IsSequence();
}

bool Config::is_mapping(std::string_view key) const {
  const YAML::Node* node = node_->find(key);
  return node != nullptr && node->IsMap();
}

YamlValue Config::value(std::string_view key) const { return value_of(node_->get(key)); }

YamlValue Config::value() const {
  YamlValue mapping;
  for (const std::string& key : keys())
    if (has(key)) mapping.put(key, value(key));
  return mapping;
}

std::vector<std::string> Config::keys() const {
  for (const std::string& key : node_->order) node_->asked.insert(key);
  return node_->order;
}

void Config::expect_all_read() const {
  for (const std::string& key : node_->order) {
    if (node_->asked.contains(key)) continue;
    std::string message = "unknown key '" + node_->dotted(key) + "'";
    const std::vector<std::string> known(node_->asked.begin(), node_->asked.end());
    if (const auto nearest = nearest_word(key, known)) {
      message += "; did you mean '" + *nearest + "'?";
    } else {
      message += "; known keys are:";
      for (const std::string& word : known) message += " " + word;
    }
    throw Error(ErrorKind::invalid_input, node_->home(key).where(node_->entries.at(key)) + message);
  }
  for (const auto& child : node_->children) Config(child).expect_all_read();
}

void Config::refuse(std::string_view key, std::string_view why) const {
  const YAML::Node* node = node_->find(key);
  node_->refuse(key, node != nullptr ? *node : node_->yaml, why);
}

const std::string& Config::name() const noexcept { return node_->file; }

KeyPlaces Config::places() const {
  KeyPlaces places;
  places.file = node_->file;
  note_places(node_->yaml, node_->path, places);
  return places;
}

std::optional<std::string> nearest_word(std::string_view word,
                                        const std::vector<std::string>& known) {
  std::optional<std::string> best;
  std::size_t best_distance = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const std::string& candidate : known) {
    std::vector<std::size_t> row(candidate.size() + 1);
    for (std::size_t j = 0; j < row.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= word.size(); ++i) {
      std::size_t diagonal = row[0];
      row[0] = i;
      for (std::size_t j = 1; j <= candidate.size(); ++j) {
        const std::size_t substitute = diagonal + (word[i - 1] == candidate[j - 1] ? 0 : 1);
        diagonal = row[j];
        row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitute});
      }
    }
    if (row.back() < best_distance) {
      best_distance = row.back();
      best = candidate;
    }
  }
  return best;
}

}  // namespace slackwater
