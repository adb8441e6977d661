#include "data/bag/recording.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "data/bag/mcap_format.h"
#include "data/bag/rosbag_format.h"
#include "fields/base/check.h"
#include "fields/base/error.h"

namespace slackwater::bag {
namespace {

constexpr std::size_t batch_bytes = std::size_t{4} << 20U;
constexpr std::chrono::seconds batch_time{1};

}  // namespace

struct Writer::State {
  std::unique_ptr<RecordingFormat> format;
  std::vector<Channel> channels;  ///< of id - 1
  std::uint64_t messages = 0;
  BeatClock clock;
  std::size_t bytes_at_hand = 0;
  std::chrono::steady_clock::time_point begun{};  ///< the batch at hand
  std::optional<Error> failure;

  State(std::unique_ptr<RecordingFormat> a_format, BeatClock a_clock)
      : format(std::move(a_format)), clock(std::move(a_clock)) {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    try {
      close();
    } catch (const std::exception&) {  // NOLINT(bugprone-empty-catch): a destructor has no caller
    }
  }

  template <typename Work>
  void guarded(const Work& work) {
    expects(format != nullptr, "a recording that was closed is used");
    if (failure) throw Error(*failure);
    try {
      work();
    } catch (const Error& error) {
      failure = error;
      format->discard_batch();
      throw;
    }
  }

  void end_batch() {
    format->end_batch();
    bytes_at_hand = 0;
  }

  void close() {
    if (format == nullptr) return;
    const std::unique_ptr<RecordingFormat> last = std::move(format);
    try {
      if (!failure) last->end_batch();
      last->finish();
    } catch (const Error&) {
      if (!failure) throw;
    }
  }
};

Writer::Writer(std::unique_ptr<State> state) : state_(std::move(state)) {}
Writer::Writer(Writer&&) noexcept = default;
Writer& Writer::operator=(Writer&&) noexcept = default;
Writer::~Writer() = default;

ChannelId Writer::add_channel(const Channel& channel) {
  std::vector<Channel>& channels = state_->channels;
  expects(!channel.topic.empty() && !channel.type.empty(), "a channel has a topic and a type");
  const auto known = std::find_if(channels.begin(), channels.end(),
                                  [&](const Channel& c) { return c.topic == channel.topic; });
  if (known != channels.end()) {
    if (known->type != channel.type) {
      throw Error(ErrorKind::invalid_input, "topic " + channel.topic + " is recorded as " +
                                                known->type + " and cannot be " + channel.type +
                                                " too; give one of them another name");
    }
    return ChannelId(static_cast<std::uint16_t>(known - channels.begin() + 1));
  }
  if (channels.size() >= std::numeric_limits<std::uint16_t>::max()) {
    throw Error(ErrorKind::invalid_input,
                "a recording holds 65535 channels and not one more; record fewer topics");
  }
  const auto id = static_cast<std::uint16_t>(channels.size() + 1);
  state_->guarded([&] { state_->format->add_channel(id, channel); });
  channels.push_back(channel);
  return ChannelId(id);
}

void Writer::write(ChannelId channel, std::int64_t log_time_ns, Payload payload) {
  const auto id = static_cast<std::uint16_t>(channel);
  expects(id >= 1 && id <= state_->channels.size(), "a channel of another recording");
  expects(log_time_ns >= 0, "log times are not negative");
  expects(payload.size() >= 4, "a payload begins with its encapsulation header");
  State& state = *state_;
  state.guarded([&] {
    const auto now = state.clock();
    if (state.bytes_at_hand == 0) state.begun = now;
    state.format->append(id, log_time_ns, payload);
    ++state.messages;
    state.bytes_at_hand += payload.size();
    if (state.bytes_at_hand >= batch_bytes || now - state.begun >= batch_time) state.end_batch();
  });
}

void Writer::flush() {
  state_->guarded([&] { state_->end_batch(); });
}

void Writer::close() { state_->close(); }

std::uint64_t Writer::messages() const noexcept { return state_->messages; }

Writer open_recording(const std::filesystem::path& path, BeatClock clock) {
  std::unique_ptr<RecordingFormat> format;
  if (path.extension() == ".mcap") {
    format = begin_mcap(path);
  } else {
    format = begin_rosbag(path);
  }
  return Writer(std::make_unique<Writer::State>(std::move(format), std::move(clock)));
}

}  // namespace slackwater::bag
