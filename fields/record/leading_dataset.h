#pragma once
#include <optional>
#include <string>

#include "fields/record/choose.h"
#include "fields/record/record.h"

namespace slackwater {

/// The dataset that leads in a time span, of what is known. Of products the one that resolves the
/// tide in time (steps of three hours or less over most of the span) before one that does not, then
/// by precedence: with the tide, of a region, of finer grid, more values, more levels, name. Of
/// in-situ series the nearest that spans the time, else the one with most values. Between the two
/// the product leads where it resolves the tide in time, because it knows the whole depth; else the
/// series; else whatever there is.
[[nodiscard]] std::optional<std::string> leading_dataset(const VectorRecord& record, UtcTime from,
                                                         UtcTime to,
                                                         const Knowledge& knowledge = {});

/// Of the products alone. @param product  only those of this product, where any of it is known
[[nodiscard]] std::optional<std::string> leading_product(const VectorRecord& record, UtcTime from,
                                                         UtcTime to, const Knowledge& knowledge,
                                                         const std::optional<std::string>& product);

}  // namespace slackwater
