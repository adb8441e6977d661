#include "api/log/attention.h"

#include <algorithm>
#include <chrono>

namespace slackwater::api {
namespace {

using store::SessionAction;

struct Open {
  std::string on;
  UtcTime since;
};

double seconds(UtcTime from, UtcTime to) {
  return std::max(0.0, std::chrono::duration<double>(to - from).count());
}

}  // namespace

std::map<unsigned, Attention> attention_of(std::span<const SessionAction> actions) {
  std::map<unsigned, Attention> all;
  std::map<unsigned, Open> open;
  const auto close = [&](unsigned seat, UtcTime at) {
    const auto found = open.find(seat);
    if (found == open.end()) return;
    const double for_s = seconds(found->second.since, at);
    all[seat].kept_s += for_s;
    all[seat].on_s[found->second.on] += for_s;
    open.erase(found);
  };
  for (const SessionAction& action : actions) {
    const bool is_attending = action.what == "attend" && action.is_taken;
    const bool is_elsewhere =
        action.what == "cut_off" || action.what == "come_back" || action.what == "leave";
    if (!is_attending && !is_elsewhere) continue;
    close(action.seat, action.at);
    if (is_attending && action.why != "off") open[action.seat] = {action.after, action.at};
  }
  while (!open.empty()) close(open.begin()->first, actions.back().at);
  return all;
}

}  // namespace slackwater::api
