#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "data/bag/channel.h"

namespace slackwater::bag {

/// A message as it was recorded.
struct Recorded {
  std::size_t channel = 0;       ///< within `Bag::channels`
  std::int64_t log_time_ns = 0;  ///< nanoseconds since the epoch of whoever recorded
  Payload payload;               ///< good until the next call of `next`
};

/// A recording that is read: each message once, in the order of log time; those of one time in the
/// order in which they were written. One thread at a time.
///
/// Memory does not grow with the recording: of an MCAP file the chunks that the present moment
/// lies in are held, and no more than 256 MiB of them.
class Bag {
 public:
  virtual ~Bag() = default;

  [[nodiscard]] virtual const std::vector<Channel>& channels() const noexcept = 0;
  /// The next message, or nothing at the end. Throws Error(invalid_input) where the recording is
  /// damaged, after which nothing more can be read.
  [[nodiscard]] virtual std::optional<Recorded> next() = 0;
  /// What a reader should know: that the recording was cut short, and where.
  [[nodiscard]] virtual const std::vector<std::string>& warnings() const noexcept = 0;
};

/// Opens a rosbag2 folder (SQLite files of any schema version, or MCAP files), one SQLite file, or
/// one MCAP file (with or without chunks, packed with zstd, lz4 or not at all, with or without a
/// summary). A recording whose writer was killed opens, with a warning where something is missing.
///
/// Throws Error(not_found) where nothing is there, and Error(invalid_input) where it is no
/// recording, is damaged from the start, is compressed as a whole, or holds messages that are not
/// CDR.
[[nodiscard]] std::unique_ptr<Bag> open_bag(const std::filesystem::path& path);

}  // namespace slackwater::bag
