#pragma once
#include <optional>
#include <string>

#include "fields/record/record.h"

namespace slackwater {

/// The dataset that leads in a time span. Of products, and of in-situ series, the one with most
/// values in the span leads (ties go to more levels, then to the name). Between the two the product
/// leads where it steps by three hours or less, which resolves tide and inertia, and spans most of
/// the time, because it knows the whole depth; else the series; else whatever there is.
[[nodiscard]] std::optional<std::string> leading_dataset(const VectorRecord& record, UtcTime from,
                                                         UtcTime to);

}  // namespace slackwater
