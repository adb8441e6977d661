#pragma once
#include <fmt/core.h>

#include <string>
#include <string_view>

namespace slackwater {

/// A format that was held against the types of its values when the program was compiled.
template <typename... Values>
using FormatOf = fmt::format_string<Values...>;

/// A text with values in it, each at its field:
///
///   formatted("found {:g} m, expected at most {:.1f} m in {}", depth_m, deepest_m, name)
///
/// The fields are those of Python and of std::format (C++20): `{}` is a whole number, a text, or
/// the shortest text that reads back as the same number; `{:g}`, `{:.3f}`, `{:.15g}`, `{:02}`
/// are printf's %g, %.3f, %.15g, %02d, to the byte. `{:>8}` stands right, `{:<8}` left. A number
/// that may be nan or inf needs the sign too where it has a width, `{:>8.1f}`: else it stands left.
/// A format that does not suit its values does not compile. Independent of the locale.
template <typename... Values>
[[nodiscard]] std::string formatted(FormatOf<Values...> format, const Values&... values) {
  return fmt::vformat(format, fmt::make_format_args(values...));
}

/// "1 granule", "3 granules".
[[nodiscard]] inline std::string counted(std::size_t n, const std::string& one) {
  return std::to_string(n) + " " + one + (n == 1 ? "" : "s");
}

/// The texts one after the other, with the separator between them: "a, b, c". Empty texts at the
/// beginning get none.
template <typename Texts>
[[nodiscard]] std::string joined(const Texts& texts, std::string_view separator) {
  std::string all;
  for (const auto& text : texts) {
    if (!all.empty()) all += separator;
    all += text;
  }
  return all;
}

/// As a sentence: begun with a capital letter, with a full stop where it has no end.
[[nodiscard]] std::string sentence(std::string text);

/// Without what is blank at its ends.
[[nodiscard]] std::string_view trimmed(std::string_view text, std::string_view blank = " \t\r");

/// A to Z in lower case, every other byte as it is.
[[nodiscard]] std::string lower_case(std::string_view text);
/// Whether `text` holds `part`, the case of A to Z ignored.
[[nodiscard]] bool contains_ignoring_case(std::string_view text, std::string_view part);

}  // namespace slackwater
