#include "api/log/action_json.h"

#include <nlohmann/json.hpp>

namespace slackwater::api {
namespace {

using nlohmann::json;

json text_or_null(const std::string& text) { return text.empty() ? json(nullptr) : json(text); }

}  // namespace

json action_json(const store::SessionAction& action) {
  return {{"number", action.number},
          {"at", format_utc(action.at)},
          {"time_s", action.time_s},
          {"step", action.step},
          {"seat", action.seat == 0 ? json(nullptr) : json(action.seat)},
          {"who", action.who},
          {"role", action.role},
          {"what", action.what},
          {"vehicle", text_or_null(action.vehicle)},
          {"before", action.before},
          {"after", action.after},
          {"taken", action.is_taken},
          {"reason", text_or_null(action.reason)},
          {"why", action.why},
          {"count", action.count}};
}

}  // namespace slackwater::api
