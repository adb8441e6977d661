#pragma once
#include <stdexcept>
#include <string>

#include "fields/base/source_place.h"

namespace slackwater {

/// A broken precondition: a bug of ours, never bad input. Only the outermost loop may catch it.
class ContractViolation : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Always armed at room boundaries; inner loops use `assert`.
inline void expects(bool condition, const char* message,
                    SourcePlace where = SourcePlace::current()) {
  if (!condition) {
    throw ContractViolation(std::string(where.file_name()) + ":" + std::to_string(where.line()) +
                            ": " + message);
  }
}

}  // namespace slackwater
