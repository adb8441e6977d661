#include "fields/service/wind_policy.h"

#include <string>

#include "fields/base/error.h"

namespace slackwater {

std::string_view name_of(WindPolicy policy) noexcept {
  switch (policy) {
    case WindPolicy::best:
      return "best";
    case WindPolicy::forecast:
      return "forecast";
    case WindPolicy::persist:
      return "persist";
  }
  return "best";
}

WindPolicy wind_policy_from(std::string_view name) {
  for (const WindPolicy policy : {WindPolicy::best, WindPolicy::forecast, WindPolicy::persist}) {
    if (name == name_of(policy)) return policy;
  }
  throw Error(ErrorKind::invalid_input,
              "found wind policy '" + std::string(name) + "', expected best, forecast or persist");
}

}  // namespace slackwater
