#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>

#include "ingest/ais/filter_program.h"
#include "ingest/ais/message.h"

namespace slackwater::ingest {

/// gpsd's decoder of AIS: `gpsdecode -j -s` with `-v`, which repeats each sentence before what it
/// says, and `-u`, which leaves numbers as they are coded: scaled, it prints the places of type 27
/// to 0.1 degree alone (gpsd 3.22). It drops times, so each answer is matched to its message by the
/// sentence that it repeats.
[[nodiscard]] FilterProgram gpsdecode_program();

/// The next message, or nothing at the end.
using NextMessage = std::function<std::optional<AisMessage>()>;
/// A message and the JSON object that gpsdecode made of it.
using OnDecoded = std::function<void(const AisMessage& message, std::string_view json)>;

/// Decodes the messages in their order. It sees only sentences that we wrote
/// (`AisMessage::sentences`): no byte of a file reaches it unchecked. Memory: the messages between
/// the two programs, some hundred.
/// @return how many it could not decode
/// @throws Error(unavailable) as `run_filter`, and where it loses sentences
[[nodiscard]] std::size_t decode_messages(const FilterProgram& decoder, const NextMessage& next,
                                          const OnDecoded& on_decoded);

}  // namespace slackwater::ingest
