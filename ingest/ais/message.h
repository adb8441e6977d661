#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ingest/ais/sentence.h"

namespace slackwater::ingest {

/// A whole AIS message, still armoured, with the time at which it (its first fragment) was
/// received.
struct AisMessage {
  std::string payload;
  int fill_bits = 0;
  bool is_own_ship = false;
  std::optional<UtcTime> time;

  /// Message type by ITU-R M.1371, 0 to 63: the first six bits.
  [[nodiscard]] int type() const noexcept;
  /// The message in sentences of our own writing, each at most 82 characters long with its CR LF.
  [[nodiscard]] std::vector<std::string> sentences() const;
};

/// What was not of use on the way from lines to messages.
struct AisLineCounts {
  std::size_t lines = 0;
  std::size_t sentences = 0;          ///< well formed
  std::size_t malformed = 0;          ///< lines that would be AIS
  std::size_t lost_fragments = 0;     ///< of messages that were never whole
  std::size_t mismatched_stamps = 0;  ///< of a sentence that is not there
  std::size_t zoneless_times = 0;     ///< that a log states without a zone: not taken
  std::string first_malformed;        ///< "line 12: a sentence with a wrong checksum"
  bool operator==(const AisLineCounts&) const = default;
};

/// Joins lines to messages: a tag block gives the time of the sentence behind it, a `$PGHP` line
/// that of the message that begins next; fragments are joined in their order, also where messages
/// interleave. At most `most_open` messages wait for their rest, none longer than `reach`
/// sentences, so that a sequence number used again does not join strangers.
class MessageAssembler {
 public:
  static constexpr std::size_t most_open = 64;
  static constexpr std::size_t reach = 200;

  /// @param assume_utc  times that a log states without a zone are UTC
  explicit MessageAssembler(bool assume_utc = false) : assume_utc_(assume_utc) {}

  /// @return the message that this line completes; of two in one line the first, the other is
  ///         malformed
  [[nodiscard]] std::optional<AisMessage> take(std::string_view line, bool is_too_long = false);
  /// What is still open is lost.
  void finish();
  [[nodiscard]] const AisLineCounts& counts() const noexcept { return counts_; }

 private:
  struct Open {
    std::string key;
    int next = 2;
    std::size_t since = 0;  ///< sentence count
    AisMessage message;
  };
  [[nodiscard]] std::optional<AisMessage> take_one(std::string_view line);
  void malformed(const std::string& reason);
  void lose(const std::deque<Open>::iterator& open);
  [[nodiscard]] std::optional<AisMessage> take_fragment(const AisSentence& sentence,
                                                        std::optional<UtcTime> time);

  bool assume_utc_;
  AisLineCounts counts_;
  std::optional<PghpStamp> stamp_;
  std::deque<Open> open_;
};

}  // namespace slackwater::ingest
