#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

namespace slackwater {

/// A value that a text is made of.
using FormatValue = std::variant<bool, char, std::int64_t, std::uint64_t, double, std::string_view>;

/// What a field of a format has to suit; in the order of FormatValue.
enum class FormatKind { flag, letter, whole, natural, real, text };

template <typename T>
constexpr FormatKind format_kind_of() {
  if constexpr (std::is_same_v<T, bool>) return FormatKind::flag;
  if constexpr (std::is_same_v<T, char>) return FormatKind::letter;
  if constexpr (std::is_floating_point_v<T>) return FormatKind::real;
  if constexpr (std::is_integral_v<T>)
    return std::is_signed_v<T> ? FormatKind::whole : FormatKind::natural;
  return FormatKind::text;
}

/// Whether a format has one field for each value, of a type that the value can have. A field is {}
/// or {:spec}, in the order of the values: no numbers, no names, no widths taken from a value.
constexpr bool format_suits(std::string_view format, std::span<const FormatKind> kinds) {
  const auto suits = [](std::string_view spec, FormatKind kind) {
    const char type = spec.empty() ? ' ' : spec.back();
    const bool has_type = (type >= 'a' && type <= 'z') || (type >= 'A' && type <= 'Z');
    const auto is_one_of = [&](std::string_view types) {
      return !has_type || types.find(type) != std::string_view::npos;
    };
    const bool has_digits = spec.find('.') != std::string_view::npos;
    switch (kind) {
      case FormatKind::flag:
        return is_one_of("sd") && !has_digits;
      case FormatKind::letter:
        return is_one_of("cd") && !has_digits;
      case FormatKind::whole:
      case FormatKind::natural:
        return is_one_of("dxXob") && !has_digits;
      case FormatKind::real:
        return is_one_of("fgeaFGEA");
      case FormatKind::text:
        return is_one_of("s");
    }
    return false;
  };
  std::size_t fields = 0;
  for (std::size_t i = 0; i < format.size(); ++i) {
    const char c = format[i];
    if (c != '{' && c != '}') continue;
    if (i + 1 < format.size() && format[i + 1] == c) {
      ++i;
      continue;
    }
    const std::size_t end = format.find_first_of("{}", i + 1);
    if (c == '}' || end == std::string_view::npos || format[end] == '{') return false;
    const std::string_view field = format.substr(i + 1, end - i - 1);
    if (!field.empty() && field.front() != ':') return false;
    if (fields == kinds.size() || !suits(field, kinds[fields])) return false;
    ++fields;
    i = end;
  }
  return fields == kinds.size();
}

/// A format that was held against the types of its values when the program was compiled.
template <typename... Values>
class FormatOf {
 public:
  // Not explicit: a literal becomes one where `formatted` is called.
  consteval FormatOf(const char* text) : text_(text) {
    constexpr std::array<FormatKind, sizeof...(Values)> kinds{format_kind_of<Values>()...};
    if (!format_suits(text_, kinds)) throw "the format does not suit its values";
  }
  [[nodiscard]] std::string_view text() const noexcept { return text_; }

 private:
  std::string_view text_;
};

template <typename T>
FormatValue format_value(const T& value) {
  constexpr FormatKind kind = format_kind_of<T>();
  if constexpr (kind == FormatKind::whole)
    return static_cast<std::int64_t>(value);
  else if constexpr (kind == FormatKind::natural)
    return static_cast<std::uint64_t>(value);
  else if constexpr (kind == FormatKind::real)
    return static_cast<double>(value);
  else if constexpr (kind == FormatKind::text)
    return std::string_view(value);
  else
    return value;
}

/// The same for a format that is known only when the program runs.
/// @throws ContractViolation where the format is none, or does not suit the values
[[nodiscard]] std::string formatted_values(std::string_view format,
                                           std::span<const FormatValue> values);

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
[[nodiscard]] std::string formatted(FormatOf<std::type_identity_t<Values>...> format,
                                    const Values&... values) {
  const std::array<FormatValue, sizeof...(Values)> all{format_value(values)...};
  return formatted_values(format.text(), all);
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

/// A to Z in lower case, every other byte as it is.
[[nodiscard]] std::string lower_case(std::string_view text);
/// Whether `text` holds `part`, the case of A to Z ignored.
[[nodiscard]] bool contains_ignoring_case(std::string_view text, std::string_view part);

}  // namespace slackwater
