#pragma once
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "api/ask/windows/windows_words.h"
#include "fields/base/error.h"

namespace slackwater::api::desk {

/// What `parse` makes of a word. @throws Error(usage) that names it
template <typename Parse>
[[nodiscard]] auto read_word(std::string_view name, const std::string& text, Parse parse) {
  try {
    return parse(text);
  } catch (const Error& problem) {
    throw Error(ErrorKind::usage, std::string(name) + ": " + problem.message());
  }
}
[[nodiscard]] inline Duration duration_in(const std::string& text) { return parse_duration(text); }
/// @throws Error(usage) for what is no number from `least` to `most`
[[nodiscard]] double number_in(std::string_view name, const std::string& text, double least,
                               double most);

/// The words of a query. What may be said several times is said again or with commas:
/// "task=blade_scan,cable_survey".
class AskedWords {
 public:
  /// @throws Error(usage) for words that are not among `known`, and what cannot be decoded
  AskedWords(const std::string& query, std::initializer_list<std::string_view> known);

  /// Empty where it was not said. @throws Error(usage) where it was said twice
  [[nodiscard]] std::string one(std::string_view name) const;
  [[nodiscard]] std::vector<std::string> all(std::string_view name) const;
  /// What `parse` makes of it; nothing where it was not said. @throws Error(usage)
  template <typename Parse>
  [[nodiscard]] auto read_one(std::string_view name, Parse parse) const {
    using Value = decltype(parse(std::string()));
    const std::string text = one(name);
    return text.empty() ? std::optional<Value>()
                        : std::optional<Value>(read_word(name, text, parse));
  }
  /// @throws Error(usage) for what is no whole number from 1 to `most`
  [[nodiscard]] std::size_t count(std::string_view name, std::size_t most,
                                  std::size_t otherwise) const;
  /// @throws Error(usage) for what is no number from `least` to `most`
  [[nodiscard]] double number(std::string_view name, double least, double most,
                              double otherwise) const;

 private:
  std::vector<std::pair<std::string, std::string>> said_;
};

/// Whether it can be the id of a task or a turbine, and no path of a file.
void expect_id(std::string_view what, const std::string& id);

/// The question about windows that a query asks: the options of `slackwater windows`, but none that
/// names a file. @throws Error(usage)
[[nodiscard]] WindowsWords windows_words(const std::string& site, const std::string& query);

}  // namespace slackwater::api::desk
