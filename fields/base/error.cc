#include "fields/base/error.h"

namespace slackwater {

std::string_view name_of(ErrorKind kind) noexcept {
  switch (kind) {
    case ErrorKind::internal:
      return "internal";
    case ErrorKind::usage:
      return "usage";
    case ErrorKind::invalid_input:
      return "invalid_input";
    case ErrorKind::not_found:
      return "not_found";
    case ErrorKind::unavailable:
      return "unavailable";
    case ErrorKind::not_converged:
      return "not_converged";
  }
  return "internal";
}

Error::Error(ErrorKind kind, std::string message, SourcePlace where)
    : kind_(kind), message_(std::move(message)), where_(where) {}

void Error::prepend(std::string_view context) { message_.insert(0, std::string(context) + ": "); }

void refuse(const std::string& why, SourcePlace where) {
  throw Error(ErrorKind::invalid_input, why, where);
}

}  // namespace slackwater
