#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "twin/account/manoeuvre_account.h"

// The figures of manoeuvres for people and as JSON.

namespace slackwater::api {

/// "turning circle": of which task it is, from 1.
[[nodiscard]] std::string manoeuvre_name(const twin::ManoeuvreAccount& manoeuvre);
/// "to starboard by 10 degrees of rudder: advance 21.3 m, transfer 12.1 m, ...; no steady turn:
/// ended at 80 degrees; approach of 1.50 m/s".
[[nodiscard]] std::string manoeuvre_text(const twin::ManoeuvreAccount& manoeuvre);
/// Degrees, metres, seconds; figures that there are not are null and in `absent`, with why.
[[nodiscard]] nlohmann::json manoeuvre_json(const twin::ManoeuvreAccount& manoeuvre);

}  // namespace slackwater::api
