#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fields/base/time.h"

namespace slackwater::ingest {

/// A VDM (received) or VDO (own ship) sentence, one fragment of an AIS message (IEC 61162-1; NMEA
/// 0183 4.0):
///
///   \s:42809,c:1635731889*6A\!AIVDM,2,1,3,B,55P5TL01VIaAL@7W...,0*1C
///     tag block (optional)      |total, number, sequence, channel, payload, fill bits, checksum
///
/// Known to be well formed: the checksum is right, the numbers are in range, the payload holds
/// armoured characters.
struct AisSentence {
  std::string key;      ///< what the fragments of one message share
  int total = 1;        ///< 1 to 9
  int number = 1;       ///< 1 to total
  std::string payload;  ///< six bits a character
  int fill_bits = 0;    ///< 0 to 5, at the end of the payload
  int checksum = 0;
  bool is_own_ship = false;            ///< VDO
  std::optional<UtcTime> time;         ///< of the tag block (`c:`)
  std::optional<UtcTime> logged_time;  ///< that a logger put before or behind (logged_time.h)
  bool logged_time_states_zone = true;
};

/// `$PGHP,1,2010,6,11,11,46,11,390,...,2B*5B`: when the message that follows was received, by the
/// clock of a GateHouse logger, to the millisecond; the last field repeats the checksum of a
/// one-sentence message.
struct PghpStamp {
  UtcTime time{};
  int checksum = 0;  ///< 0 where the logger gives none
};

/// A line of a log that carries no AIS: empty, a comment, another sentence.
struct OtherLine {};
/// A line that would be AIS and is not; never empty.
struct MalformedLine {
  std::string reason;
};

using AisLine = std::variant<AisSentence, PghpStamp, OtherLine, MalformedLine>;

/// Reads one line; takes any bytes. A tag block or stamp that is not sound is as if absent. What a
/// receiver wrote around the sentence (its clock, signal powers) is passed over but for a time. A
/// line of several sentences is malformed: `split_sentences` takes them apart.
[[nodiscard]] AisLine parse_ais_line(std::string_view line);

/// The sentences of a line that holds several, as the JSON of receivers does, each with what stands
/// before the first; a line of one or none as it is.
[[nodiscard]] std::vector<std::string> split_sentences(std::string_view line);

/// The exclusive or of all characters, as NMEA 0183 has it.
[[nodiscard]] int nmea_checksum(std::string_view text) noexcept;

}  // namespace slackwater::ingest
