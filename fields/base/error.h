#pragma once
#include <exception>
#include <string>
#include <string_view>
#include <utility>

#include "fields/base/source_place.h"

namespace slackwater {

/// What kind of trouble an `Error` is; each kind has one exit code (api/door/cli) and one HTTP
/// status (api/door/http).
enum class ErrorKind {
  internal,       ///< ours to mend
  usage,          ///< the command line makes no sense
  invalid_input,  ///< a file, a unit, a YAML key is wrong
  not_found,      ///< no such file, site, forecast or day
  unavailable,    ///< disk full, store locked or not writable, library refused
  not_converged,  ///< the calibration found no minimum
};

/// The name of a kind as it stands in JSON and messages, e.g. "invalid_input".
[[nodiscard]] std::string_view name_of(ErrorKind kind) noexcept;

/// Bad input or environment (CONTRIBUTING.md, Errors). The message says what was found, what was
/// expected and what to do.
class Error : public std::exception {
 public:
  Error(ErrorKind kind, std::string message, SourcePlace where = SourcePlace::current());

  [[nodiscard]] ErrorKind kind() const noexcept { return kind_; }
  /// The whole chain, outermost context first: "reading wind.nc: variable u10: unit 'K' ...".
  [[nodiscard]] const std::string& message() const noexcept { return message_; }
  [[nodiscard]] const char* what() const noexcept override { return message_.c_str(); }
  [[nodiscard]] const SourcePlace& where() const noexcept { return where_; }
  /// Puts "context: " in front of the message.
  void prepend(std::string_view context);

 private:
  ErrorKind kind_;
  std::string message_;
  SourcePlace where_;
};

/// Throws Error(invalid_input).
[[noreturn]] void refuse(const std::string& why, SourcePlace where = SourcePlace::current());

/// Runs `work`; an `Error` that leaves it carries `context` in front of its message.
template <typename Work>
decltype(auto) with_context(std::string_view context, Work&& work) {
  try {
    return std::forward<Work>(work)();
  } catch (Error& error) {
    error.prepend(context);
    throw;
  }
}

}  // namespace slackwater
