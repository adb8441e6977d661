#pragma once
#include <string>

#include "fields/service/snapshot.h"

namespace slackwater::api {

/// What tells a forecast that was made again from the one that was issued, as a clause ("the
/// central current of column 2 differs"); empty where they are the same to the bit. The version of
/// the program is not looked at. Of members those that the issued one holds are compared, in the
/// rounding of its file (ingest/cf/forecast/forecast_file.h); the other may hold more.
/// @param issued  as read from its file
[[nodiscard]] std::string difference_of(const Snapshot& issued, const Snapshot& made);

}  // namespace slackwater::api
