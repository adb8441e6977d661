#pragma once
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace slackwater::people {

/// A message of a station as it came in. All readers throw Error(invalid_input) that says what was
/// found and what was expected.
class StationSays {
 public:
  /// @throws Error(invalid_input) for what is no JSON object with a `do`
  explicit StationSays(std::string_view text);

  [[nodiscard]] const std::string& what() const noexcept { return what_; }
  /// Of the answer; null where the station gave none.
  [[nodiscard]] const nlohmann::json& id() const noexcept { return id_; }

  [[nodiscard]] double number(std::string_view key, double low, double high) const;
  [[nodiscard]] std::int64_t whole(std::string_view key, std::int64_t low, std::int64_t high) const;
  /// Absent where it is not there, or null.
  [[nodiscard]] std::optional<double> number_if(std::string_view key, double low,
                                                double high) const;
  /// An object within, as a message of its own; absent likewise.
  [[nodiscard]] std::optional<StationSays> object_if(std::string_view key) const;
  [[nodiscard]] bool flag(std::string_view key, bool otherwise) const;
  /// @param most  letters
  [[nodiscard]] std::string text(std::string_view key, std::size_t most) const;
  /// The same; empty where it is empty or not there.
  [[nodiscard]] std::string text_or_empty(std::string_view key, std::size_t most) const;
  [[nodiscard]] std::vector<double> numbers(std::string_view key, std::size_t most) const;
  /// A list of objects, each as a message of its own.
  [[nodiscard]] std::vector<StationSays> list(std::string_view key, std::size_t most) const;

 private:
  StationSays(nlohmann::json json, std::string what);
  [[nodiscard]] const nlohmann::json& at(std::string_view key) const;

  nlohmann::json json_;
  nlohmann::json id_;
  std::string what_;
};

}  // namespace slackwater::people
