#pragma once
#include <cstddef>
#include <span>

#include "fields/base/config.h"
#include "fields/grid/status.h"

namespace slackwater::ingest {

/// The gross range test (IOOS QARTOD manuals, test 4): values outside what sea and air can do are
/// the instrument's, not nature's. Ranges are those of data/products/variables.yaml, wide on
/// purpose.
///
/// Marks values outside the range as suspect; only samples that have a value are tested. Returns
/// how many it marked.
std::size_t test_gross_range(const Range& range, std::span<const float> values,
                             std::span<SampleStatus> status);

/// The same for the components of a vector, by its length: both are marked. Returns the number of
/// vectors.
std::size_t test_speed_range(double greatest_speed, std::span<const float> east,
                             std::span<const float> north, std::span<SampleStatus> east_status,
                             std::span<SampleStatus> north_status);

}  // namespace slackwater::ingest
