#pragma once
#include <string>

#include "fields/base/time.h"

namespace slackwater::api {

/// "18:42:14": the time of day of a moment of a run, whole seconds. @param t_s  since its start
[[nodiscard]] std::string time_of_day(UtcTime start, double t_s);
/// "18:42".
[[nodiscard]] std::string minute_of_day(UtcTime start, double t_s);

}  // namespace slackwater::api
