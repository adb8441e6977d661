#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "fields/service/snapshot.h"

namespace slackwater {

/// Where waves come from, for a reader: "wave product, forecast", "computed from the wind".
[[nodiscard]] std::string_view wave_source_words(DataStatus source) noexcept;

/// The source of the waves at a time, at the first column that has any: of the two stamps around it
/// the one that is further from a product. Nothing where the forecast has no waves then.
[[nodiscard]] std::optional<DataStatus> wave_source_at(const Snapshot& snapshot, UtcTime time);

/// The sources of the waves of the first column that has any, over the whole forecast: "wave
/// product, forecast", or, where there are several, "wave product, forecast (49 of 73 hours),
/// computed from the wind (24)". Empty where the forecast has no waves.
[[nodiscard]] std::string wave_sources_text(const Snapshot& snapshot);

/// Whether the waves of every hour, where there are any, are a product's or were measured.
[[nodiscard]] bool has_given_waves_only(const Snapshot& snapshot) noexcept;

}  // namespace slackwater
