#pragma once
#include <exception>
#include <string>
#include <string_view>

#include "api/door/http/message.h"
#include "fields/base/error.h"

namespace slackwater::api::http {

/// The reason phrase of a status, "Error" for one we do not know.
[[nodiscard]] std::string_view reason_of(int status) noexcept;

/// The one table from kinds of trouble to HTTP.
[[nodiscard]] int status_of(ErrorKind kind) noexcept;

/// An RFC 7807 document: {type, title, status, detail, instance}.
/// @param detail    what was found, expected and what to do; bytes that are not UTF-8 are replaced
/// @param instance  the path it is about; left out where empty
[[nodiscard]] Response problem(int status, const std::string& detail, const std::string& instance);

/// The problem that an exception is: only what the client caused or can mend is shown to it, the
/// rest is `Response::for_the_log`.
[[nodiscard]] Response problem_of(const std::exception_ptr& thrown, const std::string& instance);

/// What `make` makes; what it throws becomes the problem that it is.
template <typename Make>
[[nodiscard]] auto made_or_problem(const Make& make, const std::string& instance)
    -> decltype(make()) {
  try {
    return make();
  } catch (...) {
    return problem_of(std::current_exception(), instance);
  }
}

}  // namespace slackwater::api::http
