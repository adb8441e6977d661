#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "ingest/ais/gpsdecode.h"
#include "ingest/ais/track.h"

namespace slackwater::ingest {

/// How a log of AIS was read.
struct AisReading {
  AisLineCounts lines;
  std::size_t messages = 0;                      ///< whole ones, of any type; rows of a table
  std::size_t other_types = 0;                   ///< that we do not use
  std::array<std::size_t, 64> others_of_type{};  ///< the same by message type; rows of a table: 0
  std::size_t undecodable = 0;                   ///< of our types, but their bits make no report
  std::size_t untimed = 0;  ///< reports without a time: they tell who, not where
  std::array<std::size_t, 28> reports_of_type{};  ///< by message type
  /// What an operator should read of this.
  [[nodiscard]] std::vector<std::string> warnings() const;
  /// What was passed over because of its type: "3 messages ... type 8 (binary broadcast) 1, ...";
  /// empty: nothing.
  [[nodiscard]] std::string passed_over() const;
};

/// Reads a log of AIS in constant memory: NMEA 0183 sentences (VDM, VDO) with the times of `$PGHP`
/// lines, tag blocks or a receiver's clock around them, decoded by `decoder`, or a table as
/// MarineCadastre.gov or the Danish Maritime Authority publishes it; packed by Zstandard or not.
/// Reports come in the order of the log.
///
/// @param assume_utc  times that a log states without a zone are UTC; else they are not taken
/// Any bytes are taken: what is no AIS is counted. @throws Error(not_found) for a file that cannot
/// be opened, Error(invalid_input) for one without any AIS, Error(unavailable) where gpsdecode is
/// missing or dies
AisReading read_ais(const std::filesystem::path& file,
                    const std::function<void(const AisReport&)>& on_report,
                    const FilterProgram& decoder = gpsdecode_program(), bool assume_utc = false);

/// A part of a log: the lines that begin at `from` or behind it, up to `to`, in bytes.
struct AisPart {
  std::uint64_t from = 0;
  std::uint64_t to = std::numeric_limits<std::uint64_t>::max();
};

/// The same of a part of a log that somebody goes on writing. It may hold no message, and its last
/// line may not be whole. @throws as `read_ais`, but not for want of messages; and for a file that
/// is packed
AisReading read_ais_part(const std::filesystem::path& file, const AisPart& part,
                         const std::function<void(const AisReport&)>& on_report,
                         const FilterProgram& decoder = gpsdecode_program(),
                         bool assume_utc = false);

/// What to keep of a log.
struct AisTrackOptions {
  std::optional<BoundingBox> cut;  ///< positions inside
  std::optional<UtcTime> from;
  std::optional<UtcTime> to;  ///< inclusive
  std::optional<std::uint32_t> mmsi;
  bool assume_utc = false;  ///< times that a log states without a zone are UTC
  /// A bound on memory: 72 MB and as much again while they grow. A vessel weighs as much as five.
  std::size_t most_positions = 1'000'000;
};

struct AisTracks {
  std::vector<AisTrack> tracks;  ///< by MMSI
  AisReading reading;
};

/// The tracks of all vessels in a log. @throws as `read_ais`, and Error(invalid_input) for more
/// than `most_positions`
[[nodiscard]] AisTracks read_ais_tracks(const std::filesystem::path& file,
                                        const AisTrackOptions& options = {},
                                        const FilterProgram& decoder = gpsdecode_program());

}  // namespace slackwater::ingest
