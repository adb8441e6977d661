#pragma once
#include <optional>
#include <string_view>

namespace slackwater::ingest {

/// Reads a short text from left to right; every step takes what it recognises or leaves the place
/// unchanged.
class TextScanner {
 public:
  explicit TextScanner(std::string_view text) : rest_(text) {}

  [[nodiscard]] bool at_end() const noexcept { return rest_.empty(); }
  [[nodiscard]] bool at_digit() const noexcept { return !rest_.empty() && is_digit(rest_.front()); }
  /// Whether there were any.
  bool skip_blanks() noexcept {
    const std::size_t before = rest_.size();
    while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\t'))
      rest_.remove_prefix(1);
    return rest_.size() != before;
  }
  bool take(char c) noexcept {
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  /// Letters and underscores, as many as there are.
  std::string_view word() noexcept {
    std::size_t length = 0;
    while (length < rest_.size() && is_letter(rest_[length])) ++length;
    const std::string_view found = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return found;
  }
  /// A word, given in lower case, whatever its case here.
  bool take_word(std::string_view lower) noexcept {
    const std::string_view before = rest_;
    const std::string_view found = word();
    bool same = found.size() == lower.size();
    for (std::size_t i = 0; same && i < lower.size(); ++i) same = (found[i] | 0x20) == lower[i];
    if (!same) rest_ = before;
    return same;
  }
  /// An unsigned whole number of `fewest` to `most` (at most 9) digits; takes no more than `most`.
  std::optional<int> number(std::size_t fewest, std::size_t most) noexcept {
    std::size_t length = 0;
    int value = 0;
    while (length < most && length < rest_.size() && is_digit(rest_[length]))
      value = value * 10 + (rest_[length++] - '0');
    if (length < fewest || length == 0) return std::nullopt;
    rest_.remove_prefix(length);
    return value;
  }
  /// "12" or "12.345".
  std::optional<double> decimal() noexcept {
    const auto whole = number(1, 2);
    if (!whole) return std::nullopt;
    double value = *whole;
    if (take('.')) {
      for (double place = 0.1; at_digit(); place *= 0.1) {
        value += place * (rest_.front() - '0');
        rest_.remove_prefix(1);
      }
    }
    return value;
  }

 private:
  static bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }
  static bool is_letter(char c) noexcept {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  }
  std::string_view rest_;
};

}  // namespace slackwater::ingest
