#pragma once
#include <string>
#include <vector>

#include "twin/scenario/scenario.h"

namespace slackwater::api {

/// Limits of a mission that nobody could check, and those held against what is assumed.
struct Unchecked {
  std::vector<std::string> not_checked;
  std::vector<std::string> assumed;
};
[[nodiscard]] Unchecked unchecked_of(const twin::Scenario& mission);

}  // namespace slackwater::api
