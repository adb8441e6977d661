// made_up_broadcast: serves a broadcast of made-up topics at /live of a free port of this machine,
// prints {"port":...}, and publishes twenty times a second until its input ends. What message n
// says follows from its time, so that a reader can tell: see foxglove.mjs. /figures says how it
// fares.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "api/door/foxglove/broadcast.h"
#include "api/door/http/router.h"
#include "api/door/http/server.h"

namespace {

using namespace slackwater;

constexpr std::uint64_t first_ns = 1'741'590'000'000'000'000;
constexpr std::uint64_t step_ns = 50'000'000;

constexpr const char* vector_definition =
    "std_msgs/Header header\n"
    "geometry_msgs/Vector3 vector\n"
    "================================================================================\n"
    "MSG: std_msgs/Header\n"
    "builtin_interfaces/Time stamp\n"
    "string frame_id\n"
    "================================================================================\n"
    "MSG: builtin_interfaces/Time\n"
    "int32 sec\n"
    "uint32 nanosec\n"
    "================================================================================\n"
    "MSG: geometry_msgs/Vector3\n"
    "float64 x\n"
    "float64 y\n"
    "float64 z\n";

/// XCDR1, little endian, by hand; places are counted after the encapsulation header.
class Cdr {
 public:
  template <typename Number>
  Cdr& add(Number number) {
    while ((bytes_.size() - 4) % sizeof number != 0) bytes_.push_back(0);
    std::uint8_t raw[sizeof number];
    std::memcpy(raw, &number, sizeof number);
    bytes_.insert(bytes_.end(), raw, raw + sizeof number);
    return *this;
  }
  Cdr& add_text(const std::string& text) {
    add(static_cast<std::uint32_t>(text.size() + 1));
    bytes_.insert(bytes_.end(), text.begin(), text.end());
    bytes_.push_back(0);
    return *this;
  }
  [[nodiscard]] bag::Payload payload() const { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_{0, 1, 0, 0};
};

Cdr flow(std::uint64_t n, std::uint64_t time_ns) {
  Cdr cdr;
  cdr.add(static_cast<std::int32_t>(time_ns / 1'000'000'000));
  cdr.add(static_cast<std::uint32_t>(time_ns % 1'000'000'000)).add_text("harbour");
  const auto at = static_cast<double>(n);
  cdr.add(at).add(-0.5 * at).add(std::sqrt(at));
  return cdr;
}

std::uint64_t resident_bytes() {
  std::ifstream statm("/proc/self/statm");
  std::uint64_t total = 0;
  std::uint64_t resident = 0;
  statm >> total >> resident;
  return resident * 4096;
}

api::http::Response figures_of(const api::foxglove::Broadcast& live) {
  const auto figures = live.figures();
  api::http::Response response;
  response.media_type = "application/json";
  response.body = nlohmann::json{{"clients", figures.clients},
                                 {"subscriptions", figures.subscriptions},
                                 {"sent", figures.sent},
                                 {"dropped", figures.dropped},
                                 {"resident_bytes", resident_bytes()}}
                      .dump();
  return response;
}

}  // namespace

int main() {
  api::foxglove::Broadcast live("made up");
  const auto wind =
      live.advertise({"/wind/speed", "std_msgs/msg/Float64", "float64 data\n", {false, false, 5}});
  const auto vector = live.advertise(
      {"/rov/flow", "geometry_msgs/msg/Vector3Stamped", vector_definition, {true, false, 10}});
  const auto depth =
      live.advertise({"/site/depth", "std_msgs/msg/Float64", "float64 data\n", {true, true, 1}});
  const auto picture =
      live.advertise({"/sonar/picture", "std_msgs/msg/String", "string data\n", {false, false, 5}});
  live.publish(depth, first_ns, Cdr().add(35.5).payload());

  api::http::Router router;
  router.add("GET", "/live", live.route());
  router.add("GET", "/figures", [&live](const api::http::Request&) { return figures_of(live); });
  api::http::Server server({}, router);
  server.start();
  std::printf("{\"port\":%d}\n", server.port());
  std::fflush(stdout);

  std::jthread publisher([&](const std::stop_token& stop) {
    auto next = std::chrono::steady_clock::now();
    const std::string pixels(400'000, 'x');
    for (std::uint64_t n = 0; !stop.stop_requested(); ++n) {
      const std::uint64_t time_ns = first_ns + n * step_ns;
      live.set_time(time_ns);
      live.publish(wind, time_ns, Cdr().add(0.25 * static_cast<double>(n)).payload());
      live.publish(vector, time_ns, flow(n, time_ns).payload());
      live.publish(picture, time_ns, Cdr().add_text(pixels).payload());
      next += std::chrono::nanoseconds(step_ns);
      std::this_thread::sleep_until(next);
    }
  });
  while (std::getchar() != EOF) {
  }
  publisher = {};
  server.stop();
  const auto left = live.figures();
  std::printf("{\"clients\":%zu,\"subscriptions\":%zu}\n", left.clients, left.subscriptions);
  return left.clients == 0 && left.subscriptions == 0 ? 0 : 1;
}
