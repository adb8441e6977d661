#pragma once
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "api/door/http/message.h"

namespace slackwater::api::http {

/// What one request cost, once its answer is with the kernel.
struct Served {
  std::string_view route;  ///< the label; unknown ones count as "(other)"
  std::string_view method;
  int status = 200;
  std::chrono::nanoseconds took{
      0};                 ///< from the last byte of the request to the last of the answer
  std::size_t bytes = 0;  ///< of the answer, head and body
};

/// Counters of a server, written without locks, read as Prometheus text exposition 0.0.4
/// (https://prometheus.io/docs/instrumenting/exposition_formats/).
class Metrics {
 public:
  /// @param routes  the labels to tell apart, e.g. `Router::labels()`
  explicit Metrics(const std::vector<std::string>& routes);
  ~Metrics();
  Metrics(const Metrics&) = delete;
  Metrics& operator=(const Metrics&) = delete;

  void served(const Served& request) noexcept;
  void request_begun() noexcept { in_flight_.fetch_add(1, std::memory_order_relaxed); }
  void request_ended() noexcept { in_flight_.fetch_sub(1, std::memory_order_relaxed); }
  void connection_opened() noexcept;
  void connection_closed() noexcept { connections_.fetch_sub(1, std::memory_order_relaxed); }
  void websocket_opened() noexcept;
  void websocket_closed() noexcept { websockets_.fetch_sub(1, std::memory_order_relaxed); }
  void frames_sent(std::uint64_t n) noexcept {
    frames_sent_.fetch_add(n, std::memory_order_relaxed);
  }
  void frames_dropped(std::uint64_t n) noexcept {
    frames_dropped_.fetch_add(n, std::memory_order_relaxed);
  }

  [[nodiscard]] std::string exposition() const;
  [[nodiscard]] std::chrono::seconds uptime() const noexcept;

 private:
  struct Route;
  [[nodiscard]] Route& route_of(std::string_view label) noexcept;
  void append_requests(std::string& text) const;
  void append_latencies(std::string& text) const;
  void append_process(std::string& text) const;

  std::map<std::string, std::unique_ptr<Route>, std::less<>> routes_;
  Route* other_ = nullptr;
  std::atomic<std::int64_t> in_flight_{0};
  std::atomic<std::int64_t> connections_{0};
  std::atomic<std::uint64_t> accepted_{0};
  std::atomic<std::uint64_t> bytes_{0};
  std::atomic<std::int64_t> websockets_{0};
  std::atomic<std::uint64_t> websockets_opened_{0};
  std::atomic<std::uint64_t> frames_sent_{0};
  std::atomic<std::uint64_t> frames_dropped_{0};
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
  std::time_t start_time_ = std::time(nullptr);
};

/// A gauge that is told apart by one label.
struct Gauge {
  std::string name;
  std::string help;
  std::string label;
  std::vector<std::pair<std::string, double>> values;  ///< by value of the label
};

/// Gauges as Prometheus text; one without values is left out.
[[nodiscard]] std::string exposition(const std::vector<Gauge>& gauges);

/// `/metrics`: the counters, and what else is known.
/// @param gauges  asked at every call, from any thread; may be empty
[[nodiscard]] Handler metrics_handler(std::shared_ptr<const Metrics> metrics,
                                      std::function<std::vector<Gauge>()> gauges = {});

}  // namespace slackwater::api::http
