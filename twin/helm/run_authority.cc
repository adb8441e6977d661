#include "twin/helm/run_authority.h"

namespace slackwater::twin {

std::optional<std::string> RunAuthority::refusal(std::string_view client,
                                                 const std::string& other_at_helm,
                                                 double now_s) const {
  if (auto held = authority_.refusal(client, 0, name, now_s)) return held;
  if (!holder().empty() || other_at_helm.empty()) return std::nullopt;
  return other_at_helm +
         ", and nobody has the run: ask for the run before you pause it, step it or let a vehicle "
         "join";
}

std::optional<std::string> RunAuthority::claim(std::string_view client,
                                               const std::string& other_at_helm, double now_s) {
  if (auto against = refusal(client, other_at_helm, now_s)) return against;
  authority_.note_command(client, 0, Keeping::asked, now_s);
  return std::nullopt;
}

}  // namespace slackwater::twin
