#pragma once
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "api/ask/windows/windows_words.h"

namespace slackwater::api::desk {

/// The words of a query. What may be said several times is said again or with commas:
/// "task=blade_scan,cable_survey".
class AskedWords {
 public:
  /// @throws Error(usage) for words that are not among `known`, and what cannot be decoded
  AskedWords(const std::string& query, std::initializer_list<std::string_view> known);

  /// Empty where it was not said. @throws Error(usage) where it was said twice
  [[nodiscard]] std::string one(std::string_view name) const;
  [[nodiscard]] std::vector<std::string> all(std::string_view name) const;
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
