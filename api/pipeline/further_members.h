#pragma once
#include <cstddef>

#include "data/store/store.h"
#include "fields/service/snapshot.h"

namespace slackwater::api {

/// A forecast as issued, with more members than its file holds: for rehearsals that want hundreds.
///
/// Further members are drawn from the calibration that was issued: the forecast is made once more
/// from the store, as of its issue time and by its seed, with as many members as are wanted.
/// Members depend on (seed, number) alone, so that the first must be those of the file; everything
/// else must be as issued too, to the bit (snapshot_difference.h). Only then are the further ones
/// added, in the rounding of the file. The store is read and not written.
///
/// @param row      of the forecast
/// @param members  counted as `Snapshot::members`, the central one among them; no more than the
///                 file holds: the forecast as issued
/// @return as issued, with at least `members` members
/// @throws Error(unavailable) where it cannot be made again as it was issued: its inputs, or the
/// days before that its weights were earned on, are gone or changed, or another version of the
/// program reckons otherwise. Error(invalid_input) where its file is damaged.
/// Cost: that of the forecast, seconds; a second and a third try where the first differs.
[[nodiscard]] Snapshot with_further_members(store::Store& store, const store::ForecastRow& row,
                                            std::size_t members, int threads = 2);

}  // namespace slackwater::api
