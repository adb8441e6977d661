#pragma once
#include <string>

#include "fields/base/error.h"

namespace slackwater::tests {

/// What a call is refused with; "no error" where it is not.
template <typename Call>
std::string error_of(const Call& call) {
  try {
    static_cast<void>(call());
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace slackwater::tests
