#pragma once
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>

#include "data/bag/channel.h"

namespace slackwater::bag {

/// A channel within the recording that gave it.
enum class ChannelId : std::uint16_t {};

/// Tells when a second has passed; results do not depend on it.
using BeatClock = std::function<std::chrono::steady_clock::time_point()>;

/// A recording that is being written. One thread at a time: one of its own where nobody should wait
/// for the disk, as putting a batch there may take some tens of milliseconds.
///
/// Messages are gathered in batches. A batch goes to the disk once it holds 4 MiB, with the first
/// message that comes a second after it began, and at `flush`. From then on it outlives the death
/// of this process; after `close` it outlives a power cut.
///
/// Where the disk is full or failing, the call that meets it throws Error(unavailable) with the
/// path and the reason; the batch at hand is lost, what was written before stays readable, and
/// every later call but `close` throws the same again at once: callers go on without the recording.
class Writer {
 public:
  Writer(Writer&&) noexcept;
  Writer& operator=(Writer&&) noexcept;
  /// Closes; trouble in doing so is not told.
  ~Writer();

  /// The same topic and type again are the same channel. The topic again with another type is
  /// refused: Error(invalid_input).
  [[nodiscard]] ChannelId add_channel(const Channel& channel);

  /// @param log_time_ns  nanoseconds since 1970 or since the epoch of the simulation; not negative.
  ///                     Times may go back: messages are written in the order given.
  /// @param payload      XCDR1 with its encapsulation header: four bytes at least
  void write(ChannelId channel, std::int64_t log_time_ns, Payload payload);
  void flush();
  /// Completes the recording; nothing can be written after it. Does nothing when called again. A
  /// recording that failed is completed where the disk allows it, without a further word.
  void close();

  /// Written so far, the batch at hand included.
  [[nodiscard]] std::uint64_t messages() const noexcept;

 private:
  friend Writer open_recording(const std::filesystem::path& path, BeatClock clock);
  struct State;
  explicit Writer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Begins a recording: an MCAP file (https://mcap.dev) where the path ends in ".mcap", otherwise a
/// rosbag2 folder with a SQLite file in it.
///
/// Throws Error(invalid_input) where something lies at that path already, Error(unavailable) where
/// it cannot be made.
[[nodiscard]] Writer open_recording(const std::filesystem::path& path,
                                    BeatClock clock = std::chrono::steady_clock::now);

}  // namespace slackwater::bag
