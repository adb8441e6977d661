#include "api/pipeline/sources_json.h"

#include <nlohmann/json.hpp>

namespace slackwater::api {

using nlohmann::json;

json sources_json(const std::vector<SourceUse>& uses) {
  json list = json::array();
  for (const SourceUse& use : uses) {
    list.push_back({{"quantity", use.quantity},
                    {"product", use.product},
                    {"run", use.run},
                    {"members", use.members},
                    {"from_height_m", use.from_height_m ? json(*use.from_height_m) : json(nullptr)},
                    {"distance_m", use.distance_m},
                    {"from", format_utc(use.from)},
                    {"to", format_utc(use.to)},
                    {"why", use.why},
                    {"revised_times", use.revised_times},
                    {"may_be_revised", use.may_be_revised},
                    {"text", text_of(use)}});
  }
  return list;
}

}  // namespace slackwater::api
