#pragma once
#include <string>

#include "fields/base/text.h"

namespace slackwater::tests {

/// A task of one ROV, "eye", at a pile, that has to bring a fifth of its battery's charge home.
/// @param limit_m_s  of the current, on its way and at work
/// @param more       lines of YAML of the agent: its work, what it inspects
inline std::string eye_task(const std::string& id, double speed_m_s, double limit_m_s,
                            const std::string& more) {
  return formatted(
             R"(id: {}
name: A task of an eye
agents:
  - role: eye
    kinds: [rov]
    needs: [camera]
    model: bluerov2_heavy
    speed_m_s: {:g}
    start: {{distance_m: 12, depth_m: 3}}
    launch_s: 10
    recovery_s: 10
    conduct:
      autonomy: auto
      reserve: {{share: 0.2, margin: 1.3}}
      limits:
        - {{current_speed_m_s: {:g}, phases: [transit, work], source: nobody, status: estimate}}
)",
             id, speed_m_s, limit_m_s) +
         more;
}

}  // namespace slackwater::tests
