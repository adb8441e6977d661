#pragma once
#include <cstdint>

#include "data/bag/channel.h"

namespace slackwater::bag {

/// What a kind of recording must know to do; `Writer` says when. All but `discard_batch` may throw
/// Error(unavailable).
class RecordingFormat {
 public:
  virtual ~RecordingFormat() = default;
  /// Ids come in turn, from 1.
  virtual void add_channel(std::uint16_t id, const Channel& channel) = 0;
  virtual void append(std::uint16_t id, std::int64_t log_time_ns, Payload payload) = 0;
  /// What was appended reaches the file.
  virtual void end_batch() = 0;
  /// Forgets what did not reach it.
  virtual void discard_batch() noexcept = 0;
  /// Completes the file and sees it to the disk.
  virtual void finish() = 0;
};

}  // namespace slackwater::bag
