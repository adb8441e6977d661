#include <limits>
#include <vector>

#include "data/bag/mcap_bag.h"
#include "tests/fuzz/fuzz_case.h"
#include "tests/fuzz/scratch_folder.h"

namespace {

using namespace slackwater;

/// What was read, message by message.
struct Read {
  std::size_t channel;
  std::int64_t log_time_ns;
  std::size_t bytes;

  bool operator==(const Read&) const = default;
};

std::vector<Read> all_of(bag::Bag& recording) {
  std::vector<Read> messages;
  std::int64_t before = std::numeric_limits<std::int64_t>::min();
  std::uint8_t sum = 0;
  while (const auto message = recording.next()) {
    fuzz::claim(message->channel < recording.channels().size(), "a channel that is not there");
    fuzz::claim(message->log_time_ns >= before, "a message out of time");
    before = message->log_time_ns;
    for (const std::uint8_t byte : message->payload) sum = static_cast<std::uint8_t>(sum + byte);
    messages.push_back({message->channel, message->log_time_ns, message->payload.size() + sum});
  }
  fuzz::claim(!recording.next(), "a message after the last");
  return messages;
}

}  // namespace

/// A recording: an MCAP file of anybody's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = fuzz::scratch_folder().file_of(data, size, "recording.mcap");
  std::vector<Read> messages;
  const bool is_read = fuzz::accepts([&] { messages = all_of(*bag::open_mcap(file)); });
  if (is_read) {
    // However little is held at a time, the messages are the same.
    std::vector<Read> again;
    fuzz::claim(fuzz::accepts([&] { again = all_of(*bag::open_mcap(file, 1)); }),
                "what was read is refused");
    fuzz::claim(again == messages, "other messages where less is held");
  }
  return 0;
}
