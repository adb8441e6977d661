#pragma once
#include "api/pipeline/fetch/wanted_files.h"
#include "data/store/store.h"

namespace slackwater::api {

/// Leaves out of what is wanted the days that the store holds already, from the first on, as they
/// were three days later or after: until then products better them.
void leave_out_stored(store::Store& store, const Site& site, UtcDay day,
                      std::vector<WantedFile>& wanted);

}  // namespace slackwater::api
