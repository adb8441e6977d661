#include "fields/service/forecast_origin.h"

#include <string>

#include "fields/base/error.h"

namespace slackwater {

std::string_view name_of(ForecastOrigin origin) noexcept {
  switch (origin) {
    case ForecastOrigin::forecast:
      return "forecast";
    case ForecastOrigin::hindcast:
      return "hindcast";
  }
  return "forecast";
}

ForecastOrigin forecast_origin_from(std::string_view name) {
  for (const ForecastOrigin origin : {ForecastOrigin::forecast, ForecastOrigin::hindcast}) {
    if (name == name_of(origin)) return origin;
  }
  throw Error(ErrorKind::invalid_input,
              "found forecast origin '" + std::string(name) + "', expected forecast or hindcast");
}

}  // namespace slackwater
