#pragma once
#include <string>
#include <string_view>

#include "fields/base/text.h"
#include "twin/run/printable.h"

namespace slackwater::api {

/// Under which a person is known as a source of commands: to the arbiter, and in a run's log.
[[nodiscard]] inline std::string source_of_person(unsigned seat, std::string_view name) {
  return formatted("people/{} {}", seat, twin::printable(name));
}

}  // namespace slackwater::api
