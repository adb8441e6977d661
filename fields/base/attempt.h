#pragma once
#include <functional>
#include <optional>
#include <string>

#include "fields/base/error.h"

namespace slackwater {

/// Why a part of a job was not done.
struct Failure {
  ErrorKind kind = ErrorKind::internal;
  std::string why;  ///< in words for a reader; of a bug also where it is
};

/// Runs one part of a job whose other parts go on without it: what stopped the part comes back as a
/// value, nothing where it was done. What the part had changed before it stopped stays changed: let
/// it work on a value of its own.
///
/// Here, and nowhere else below the commands, a bug (ContractViolation or any other exception) is
/// caught: a daily job of many parts is one of the outermost loops that may (CONTRIBUTING.md),
/// since a coordinator without waves still needs the current. The caller has to name the failure to
/// its reader. Memory that has run out stops everything and passes through.
[[nodiscard]] std::optional<Failure> attempt(const std::function<void()>& part);

}  // namespace slackwater
