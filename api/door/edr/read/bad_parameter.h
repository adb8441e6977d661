#pragma once
#include <cstddef>
#include <string>
#include <string_view>

#include "fields/base/error.h"

namespace slackwater::api::edr {

/// Of a stranger's text, messages show this many bytes.
constexpr std::size_t shown_bytes = 80;

/// A stranger's text as messages may show it: bytes that are not printable ASCII become '.', and
/// what is longer than `shown_bytes` is cut and ends in "...".
[[nodiscard]] std::string shown(std::string_view text);

/// The refusal of a query parameter, kind usage (HTTP 400): "NAME: found
/// 'TEXT'; expected EXPECTED".
/// @param expected  what would have been right, with an example
[[nodiscard]] Error bad_parameter(std::string_view name, std::string_view found,
                                  std::string_view expected,
                                  SourcePlace where = SourcePlace::current());

/// Throws the refusal of a text longer than `limit` bytes: every parser asks this first, so that
/// its time and memory are bounded.
void expect_short(std::string_view name, std::string_view text, std::size_t limit);

}  // namespace slackwater::api::edr
