// made_up_bags write FOLDER: recordings of made-up levels and winds, of both kinds, whole and left
// in the middle, and what is in them (FOLDER/expected.json); the record of a session as a bag, and
// its rows (FOLDER/session.json).
// made_up_bags read RECORDING: what our reader finds in it, as JSON on standard output.
#include <unistd.h>

#include <bit>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "api/door/live/action_bag.h"
#include "api/log/action_json.h"
#include "data/bag/bag.h"
#include "data/bag/recording.h"
#include "fields/base/error.h"
#include "fields/base/numbers/random.h"

namespace {

using namespace slackwater;
using nlohmann::json;

constexpr std::uint64_t seed = 1;
constexpr std::int64_t start_ns = 1'700'000'000'000'000'000;

/// XCDR1, little endian, by hand: numbers are aligned to their size, counted from the fifth byte.
class Cdr {
 public:
  template <typename Number>
  Cdr& number(Number value) {
    while ((bytes_.size() - 4) % sizeof(Number) != 0) bytes_.push_back(0);
    for (std::size_t i = 0; i < sizeof(Number); ++i)
      bytes_.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    return *this;
  }
  Cdr& real(double value) { return number(std::bit_cast<std::uint64_t>(value)); }
  Cdr& text(const std::string& value) {
    number(static_cast<std::uint32_t>(value.size() + 1));
    bytes_.insert(bytes_.end(), value.begin(), value.end());
    bytes_.push_back(0);
    return *this;
  }
  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_{0, 1, 0, 0};
};

bag::Channel level(const std::string& topic) {
  return {topic, "std_msgs/msg/Float64", "float64 data\n", {true, true, 1}};
}

bag::Channel wind() {
  const std::string bar = std::string(80, '=') + "\n";
  return {"/site/wind",
          "geometry_msgs/msg/Vector3Stamped",
          "# Where the air goes.\nstd_msgs/Header header\nVector3 vector\n" + bar +
              "MSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n" + bar +
              "MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n" + bar +
              "MSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n",
          {false, false, 5}};
}

struct MadeUp {
  bag::Channel channel;
  std::int64_t log_time_ns = 0;
  std::vector<std::uint8_t> payload;
  json values;
};

/// Each fifth message is logged late, before one that was logged earlier.
std::vector<MadeUp> made_up_messages() {
  Rng rng(seed, "strangers/made_up_bags");
  std::vector<MadeUp> messages;
  for (std::int64_t i = 0; i < 3000; ++i) {
    MadeUp message;
    message.log_time_ns = start_ns + i * 10'000'000 + (i % 5 == 0 ? 25'000'000 : 0);
    if (i % 3 == 0) {
      const std::int64_t stamp_ns = message.log_time_ns - 1234;
      const std::string frame = i % 2 == 0 ? "map" : "a/longer_frame";
      const double x = rng.uniform(-30, 30);
      const double y = rng.uniform(-30, 30);
      const auto sec = static_cast<std::uint32_t>(stamp_ns / 1'000'000'000);
      const auto nanosec = static_cast<std::uint32_t>(stamp_ns % 1'000'000'000);
      message.channel = wind();
      message.payload =
          Cdr().number(sec).number(nanosec).text(frame).real(x).real(y).real(0).bytes();
      message.values = {sec, nanosec, frame, x, y, 0.0};
    } else {
      const double value = rng.uniform(-3, 3);
      message.channel = level(i % 3 == 1 ? "/site/tide_level" : "/site/other_level");
      message.payload = Cdr().real(value).bytes();
      message.values = {value};
    }
    messages.push_back(std::move(message));
  }
  return messages;
}

std::string hex_of(bag::Payload bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) {
    text += "0123456789abcdef"[byte >> 4U];
    text += "0123456789abcdef"[byte & 15U];
  }
  return text;
}

void record(bag::Writer& writer, const std::vector<MadeUp>& messages) {
  for (std::size_t i = 0; i < messages.size(); ++i) {
    const MadeUp& message = messages[i];
    writer.write(writer.add_channel(message.channel), message.log_time_ns, message.payload);
    if (i % 100 == 99) writer.flush();
  }
}

/// Rows with letters that JSON and CDR have to carry.
void write_session(const std::filesystem::path& folder) {
  std::vector<store::SessionAction> actions;
  json rows = json::array();
  for (std::uint64_t i = 1; i <= 100; ++i) {
    store::SessionAction action;
    action.number = i;
    action.at = UtcTime(
        std::chrono::milliseconds(start_ns / 1'000'000 + static_cast<std::int64_t>(i) * 137));
    action.time_s = 0.05 * static_cast<double>(i);
    action.seat = static_cast<unsigned>(1 + i % 3);
    action.who = i % 2 == 0 ? "Zo\xC3\xAB \"Z\"" : "Ann";
    action.role = "operator";
    action.what = "say";
    action.after = std::string(i, 'x') + "\\,\n";
    rows.push_back(api::action_json(action));
    actions.push_back(std::move(action));
  }
  std::ofstream(folder / "session.json") << rows;
  live::write_action_bag(folder / "session.mcap", actions);
}

void write(const std::filesystem::path& folder) {
  write_session(folder);
  const auto messages = made_up_messages();
  json list = json::array();
  for (const MadeUp& message : messages)
    list.push_back({{"topic", message.channel.topic},
                    {"type", message.channel.type},
                    {"log_time_ns", message.log_time_ns},
                    {"values", message.values},
                    {"payload", hex_of(message.payload)}});
  std::ofstream(folder / "expected.json") << list;
  for (const char* name : {"whole", "whole.mcap"}) {
    bag::Writer writer = bag::open_recording(folder / name);
    record(writer, messages);
    writer.close();
  }
  // Left as a recorder leaves them that is killed.
  auto folder_left = bag::open_recording(folder / "left");
  auto file_left = bag::open_recording(folder / "left.mcap");
  for (bag::Writer* writer : {&folder_left, &file_left}) {
    record(*writer, messages);
    writer->flush();
    const auto payload = Cdr().real(0).bytes();
    writer->write(writer->add_channel(level("/site/tide_level")), start_ns, payload);
  }
  _exit(0);
}

void read(const std::filesystem::path& path) {
  const auto recording = bag::open_bag(path);
  json channels = json::array();
  for (const bag::Channel& c : recording->channels())
    channels.push_back({{"topic", c.topic},
                        {"type", c.type},
                        {"definition", c.definition},
                        {"is_reliable", c.quality.is_reliable},
                        {"is_transient_local", c.quality.is_transient_local},
                        {"depth", c.quality.depth}});
  json messages = json::array();
  while (const auto message = recording->next())
    messages.push_back({message->channel, message->log_time_ns, hex_of(message->payload)});
  const json all{
      {"channels", channels}, {"messages", messages}, {"warnings", recording->warnings()}};
  std::printf("%s\n", all.dump().c_str());
}

}  // namespace

int main(int argc, char** argv) {
  const std::string verb = argc == 3 ? argv[1] : "";
  if (verb != "write" && verb != "read") {
    std::fprintf(stderr, "give write FOLDER or read RECORDING\n");
    return 2;
  }
  try {
    verb == "write" ? write(argv[2]) : read(argv[2]);
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s\n", problem.what());
    return 1;
  }
  return 0;
}
