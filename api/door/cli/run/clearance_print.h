#pragma once
#include "twin/account/vehicle_account.h"

namespace slackwater::api {

/// How near each vehicle came to what was around it, and its clearance alarms, for people: a line
/// each. Nothing for one that met nobody and does not keep clear.
void print_clearance(const twin::RunAccount& account);

}  // namespace slackwater::api
