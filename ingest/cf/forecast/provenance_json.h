#pragma once
#include <string>
#include <string_view>

#include "fields/service/provenance.h"

namespace slackwater::ingest {

/// The text of the attribute `slackwater_provenance`: one JSON object, keys in alphabetical order,
/// without those that are not known. A number that is not finite is null.
[[nodiscard]] std::string provenance_json(const Provenance& provenance);

/// Reads it back; keys of later versions are passed over. Throws Error(invalid_input) for text that
/// is not such an object.
[[nodiscard]] Provenance provenance_from(std::string_view text);

}  // namespace slackwater::ingest
