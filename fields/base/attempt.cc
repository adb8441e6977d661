#include "fields/base/attempt.h"

#include <new>

#include "fields/base/check.h"

namespace slackwater {
namespace {

/// "growth.cc:124: what was broken", without the folders that the program was built in.
std::string bug_text(const std::string& what) {
  const std::size_t place_ends = what.find(": ");
  const std::size_t slash = what.rfind('/', place_ends);
  const std::size_t begin = slash == std::string::npos ? 0 : slash + 1;
  return "internal error, please report it (" + what.substr(begin) + ")";
}

}  // namespace

std::optional<Failure> attempt(const std::function<void()>& part) {
  try {
    part();
    return std::nullopt;
  } catch (const Error& problem) {
    return Failure{problem.kind(), problem.message()};
  } catch (const ContractViolation& bug) {
    return Failure{ErrorKind::internal, bug_text(bug.what())};
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& bug) {
    return Failure{ErrorKind::internal,
                   std::string("internal error, please report it (") + bug.what() + ")"};
  }
}

}  // namespace slackwater
