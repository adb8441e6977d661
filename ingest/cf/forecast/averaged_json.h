#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "fields/service/averaged_currents.h"

namespace slackwater::ingest {

/// The text of the attribute `slackwater_averaged_currents`, and the value of `averaged` in every
/// JSON of ours: {"mean_h", "holds_part_of_the_tide", "unresolved_tide_m_s", "tidal_record"}, the
/// last two null where no record tells of the tide; "null" for nothing.
[[nodiscard]] std::string averaged_json(const std::optional<AveragedCurrents>& averaged);

/// Reads it back; keys of later versions are passed over. Throws Error(invalid_input) for text that
/// is not such an object.
[[nodiscard]] std::optional<AveragedCurrents> averaged_from(std::string_view text);

}  // namespace slackwater::ingest
