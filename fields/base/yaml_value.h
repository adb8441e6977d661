#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace slackwater {

/// What stands in a YAML file, as a plain value: a number, a word, a list, or a mapping in the
/// order of the file. To be made, kept, compared, shared between threads and written; `Config`
/// reads one strictly.
///
/// A word that a number would be written as is that number: `5` is one, `05` and `5.0` are words.
class YamlValue {
 public:
  YamlValue() = default;  ///< an empty mapping
  YamlValue(double number);
  YamlValue(std::string word);
  YamlValue(const char* word);
  YamlValue(bool flag);
  YamlValue(std::vector<YamlValue> list);
  [[nodiscard]] static YamlValue words(const std::vector<std::string>& words);  ///< a list
  [[nodiscard]] static YamlValue numbers(const std::vector<double>& numbers);   ///< a list

  [[nodiscard]] bool is_mapping() const noexcept { return kind_ == Kind::mapping; }
  [[nodiscard]] bool is_list() const noexcept { return kind_ == Kind::list; }
  [[nodiscard]] bool is_empty() const noexcept { return items_.empty(); }
  /// Of a number or a word: its text.
  [[nodiscard]] std::string scalar() const;
  /// Of a mapping, as many as items.
  [[nodiscard]] const std::vector<std::string>& keys() const noexcept { return keys_; }
  /// Of a list or a mapping.
  [[nodiscard]] const std::vector<YamlValue>& items() const noexcept { return items_; }

  /// Of a mapping: puts a value in the place of what the key had, else at the end.
  YamlValue& put(std::string_view key, YamlValue value);

  bool operator==(const YamlValue&) const = default;

 private:
  enum class Kind { number, word, list, mapping };
  Kind kind_ = Kind::mapping;
  double number_ = 0;
  std::string word_;
  std::vector<std::string> keys_;
  std::vector<YamlValue> items_;

  friend std::string yaml_of(const YamlValue& value);
  friend std::string in_line(const YamlValue& value);
};

/// As a file: long lists and mappings a line for each entry, short ones in line. Numbers come back
/// to the bit.
[[nodiscard]] std::string yaml_of(const YamlValue& value);
/// On one line.
[[nodiscard]] std::string in_line(const YamlValue& value);

/// A text as YAML, quoted.
[[nodiscard]] std::string quoted_yaml(const std::string& text);

}  // namespace slackwater
