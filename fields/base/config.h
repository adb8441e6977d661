#pragma once
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "fields/base/key_places.h"
#include "fields/base/yaml_value.h"

namespace slackwater {

/// The values a number may take, both ends included.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool operator==(const Range&) const = default;
};

/// One mapping of a YAML file, read strictly: every key is asked for by name, every number has a
/// range, and `expect_all_read` refuses keys nobody asked for, naming the line and the nearest
/// known key.
///
/// All errors are Error(invalid_input) that begin with "FILE:LINE: key: ...". Copies share the
/// record of keys that were read. Not thread-safe.
class Config {
 public:
  /// Throws Error(not_found) / Error(invalid_input). Files over 4 MiB or nested deeper than 64 are
  /// refused.
  [[nodiscard]] static Config load(const std::filesystem::path& file);
  [[nodiscard]] static Config parse(std::string_view yaml, std::string_view name);
  /// Reads a mapping that is a value already. @param name  stands for file and line in errors
  [[nodiscard]] static Config of(const YamlValue& mapping, std::string_view name);
  /// The keys of this mapping, and those of another that it does not have; each keeps its file and
  /// line. All of them count as read in the two, and are to be read in the result.
  /// @param left_out  keys of neither
  [[nodiscard]] Config merged_over(const Config& base, const std::set<std::string>& left_out) const;

  [[nodiscard]] bool has(std::string_view key) const;
  [[nodiscard]] double number(std::string_view key, Range range) const;
  [[nodiscard]] std::optional<double> optional_number(std::string_view key, Range range) const;
  [[nodiscard]] int integer(std::string_view key, int low, int high) const;
  [[nodiscard]] std::optional<int> optional_integer(std::string_view key, int low, int high) const;
  [[nodiscard]] std::string text(std::string_view key) const;
  [[nodiscard]] std::optional<std::string> optional_text(std::string_view key) const;
  [[nodiscard]] std::optional<bool> optional_flag(std::string_view key) const;
  [[nodiscard]] std::vector<std::string> texts(
      std::string_view key) const;  ///< [] if absent; a lone scalar is a list of one
  [[nodiscard]] std::vector<double> numbers(std::string_view key,
                                            Range range) const;  ///< [] if absent
  [[nodiscard]] Config child(std::string_view key) const;        ///< a mapping; error if absent
  [[nodiscard]] std::optional<Config> optional_child(std::string_view key) const;
  [[nodiscard]] std::vector<Config> children(
      std::string_view key) const;  ///< a list of mappings; [] if absent
  [[nodiscard]] bool is_list(std::string_view key) const;
  [[nodiscard]] bool is_mapping(std::string_view key) const;
  /// A key and all below it as a plain value, counted as read: for what is handed on. Error if
  /// absent.
  [[nodiscard]] YamlValue value(std::string_view key) const;
  /// This mapping likewise.
  [[nodiscard]] YamlValue value() const;
  /// The keys of this mapping in file order; marks them all as read (for free-form maps).
  [[nodiscard]] std::vector<std::string> keys() const;

  /// Throws for any key of this mapping, or of a mapping read from it, that was never asked for.
  void expect_all_read() const;
  /// An Error about this key, with file and line, for rules between keys.
  [[noreturn]] void refuse(std::string_view key, std::string_view why) const;
  [[nodiscard]] const std::string& name() const noexcept;
  /// Where the keys of this mapping stand, and those of all below it; counts none of them as read.
  [[nodiscard]] KeyPlaces places() const;

 private:
  struct Node;
  explicit Config(std::shared_ptr<Node> node) : node_(std::move(node)) {}
  std::shared_ptr<Node> node_;
};

/// The known word closest to `word` by edit distance, or nothing if none is near.
[[nodiscard]] std::optional<std::string> nearest_word(std::string_view word,
                                                      const std::vector<std::string>& known);

}  // namespace slackwater
