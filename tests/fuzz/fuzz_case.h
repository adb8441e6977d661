#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

#include "fields/base/error.h"

namespace slackwater::fuzz {

/// Says what was wrong and aborts, which libFuzzer and the replay both report with the input.
[[noreturn]] void fail(std::string_view what) noexcept;

/// A claim about what a parser returned.
inline void claim(bool holds, std::string_view what) noexcept {
  if (!holds) fail(what);
}

/// Runs `work`. An `Error` may leave it: the input was refused, with a sentence. Anything else that
/// leaves it, a ContractViolation or an exception of a library, is a finding.
/// @return whether the input was accepted
template <typename Work>
bool accepts(Work&& work) noexcept {
  try {
    std::forward<Work>(work)();
    return true;
  } catch (const Error& error) {
    claim(!error.message().empty(), "an Error without a message");
    claim(error.kind() != ErrorKind::internal, error.message());
    return false;
  } catch (const std::exception& other) {
    fail(other.what());
  }
}

[[nodiscard]] inline std::string_view text_of(const std::uint8_t* data, std::size_t size) noexcept {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace slackwater::fuzz
