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
#include "fields/base/error.h"
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

/// All of it between brackets and braces.
void lay_in_line(YAML::Node& node) {
  node.SetStyle(YAML::EmitterStyle::Flow);
  for (auto entry : node) {
    YAML::Node below = node.IsMap() ? entry.second : entry;
    lay_in_line(below);
  }
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
                    where(entry.first) + "key '" + key + "' stands twice; keep one");
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
  std::string where(const YAML::Node& node) const {
    return file + ":" + std::to_string(node.Mark().line + 1) + ": ";
  }
  std::string dotted(std::string_view key) const {
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
    throw Error(ErrorKind::invalid_input, where(node) + dotted(key) + ": " + std::string(why));
  }
  double number(std::string_view key, const YAML::Node& node, Range range) const {
    double value = 0;
    if (!node.IsScalar() || !YAML::convert<double>::decode(node, value)) {
      const auto meant = node.IsScalar() ? with_decimal_point(node.Scalar()) : std::nullopt;
      refuse(key, node,
             "found " + shape(node) + " where a number was expected" +
                 (meant ? "; decimals stand after a point: write " + *meant : ""));
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

Config Config::load(const std::filesystem::path& file) {
  std::error_code problem;
  if (std::filesystem::is_directory(file, problem)) {
    throw Error(ErrorKind::invalid_input, "found the folder " + file.string() +
                                              " where a YAML file was expected; name a file in it");
  }
  const auto size = std::filesystem::file_size(file, problem);
  if (problem) {
    throw Error(ErrorKind::not_found,
                "cannot read " + file.string() + ": " + problem.message() + "; check the path");
  }
  if (size > largest_file) {
    throw Error(ErrorKind::invalid_input,
                file.string() + ": longer than 4 MiB; this is not a configuration file");
  }
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream) throw Error(ErrorKind::unavailable, "cannot read " + file.string());
  return parse(text.str(), file.string());
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
  auto child = std::make_shared<Node>(*node, node_->file, node_->dotted(key));
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
    auto child = std::make_shared<Node>(entry, node_->file,
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

std::string Config::flow_yaml(std::string_view key) const {
  YAML::Node value = YAML::Clone(node_->get(key));
  lay_in_line(value);
  YAML::Emitter out;
  out << value;
  return out.c_str();
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
    throw Error(ErrorKind::invalid_input, node_->where(node_->entries.at(key)) + message);
  }
  for (const auto& child : node_->children) Config(child).expect_all_read();
}

void Config::refuse(std::string_view key, std::string_view why) const {
  const YAML::Node* node = node_->find(key);
  node_->refuse(key, node != nullptr ? *node : node_->yaml, why);
}

const std::string& Config::name() const noexcept { return node_->file; }

std::string quoted_yaml(const std::string& text) {
  YAML::Emitter out;
  out << YAML::DoubleQuoted << text;
  return out.c_str();
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
