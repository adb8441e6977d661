#include "api/door/http/metrics.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "fields/base/text.h"

namespace slackwater::api::http {
namespace {

constexpr std::array<std::string_view, 5> methods{"GET", "HEAD", "OPTIONS", "POST", "(other)"};
constexpr std::array<int, 24> statuses{101, 200, 201, 202, 204, 301, 302, 303, 304, 308, 400, 401,
                                       403, 404, 405, 406, 408, 413, 414, 426, 431, 500, 501, 503};
/// Upper bounds in seconds; the target of a small answer is 0.005.
constexpr std::array<double, 13> bounds_s{0.0005, 0.001, 0.0025, 0.005, 0.01, 0.025, 0.05,
                                          0.1,    0.25,  0.5,    1,     2.5,  10};

using Counter = std::atomic<std::uint64_t>;

template <typename Table, typename Value>
std::size_t slot_of(const Table& table, const Value& value) noexcept {
  return static_cast<std::size_t>(std::find(table.begin(), table.end(), value) - table.begin());
}

void add(Counter& counter, std::uint64_t n) noexcept {
  counter.fetch_add(n, std::memory_order_relaxed);
}

std::string number(double value) { return formatted("{:.9g}", value); }

/// A label value: backslash, quote and line feed are escaped.
std::string in_quotes(std::string_view value) {
  std::string text = "\"";
  for (const char c : value) {
    if (c == '\\' || c == '"') text += '\\';
    text += c == '\n' ? std::string("\\n") : std::string(1, c);
  }
  return text + "\"";
}

void append_header(std::string& text, std::string_view name, std::string_view type,
                   std::string_view help) {
  text.append("# HELP ").append(name).append(" ").append(help).append("\n# TYPE ");
  text.append(name).append(" ").append(type).append("\n");
}

void append_metric(std::string& text, std::string_view name, std::string_view type,
                   std::string_view help, const std::string& value) {
  append_header(text, name, type, help);
  text.append(name).append(" ").append(value).append("\n");
}

/// Resident memory now, from /proc/self/statm; 0 where that cannot be read.
std::uint64_t resident_bytes() {
  std::ifstream statm("/proc/self/statm");
  std::uint64_t total = 0;
  std::uint64_t resident = 0;
  statm >> total >> resident;
  return resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace

struct Metrics::Route {
  std::array<std::array<Counter, statuses.size() + 1>, methods.size()> requests{};
  std::array<Counter, bounds_s.size() + 1> latency{};
  Counter latency_sum_ns{0};
};

Metrics::Metrics(const std::vector<std::string>& routes) {
  for (const std::string& label : routes) routes_.emplace(label, std::make_unique<Route>());
  routes_.emplace("(refused)", std::make_unique<Route>());
  other_ = routes_.emplace("(other)", std::make_unique<Route>()).first->second.get();
}

Metrics::~Metrics() = default;

Metrics::Route& Metrics::route_of(std::string_view label) noexcept {
  const auto found = routes_.find(label);
  return found == routes_.end() ? *other_ : *found->second;
}

void Metrics::served(const Served& request) noexcept {
  Route& route = route_of(request.route);
  const std::size_t method = std::min(slot_of(methods, request.method), methods.size() - 1);
  add(route.requests[method][slot_of(statuses, request.status)], 1);
  const double seconds = std::chrono::duration<double>(request.took).count();
  const auto bound = std::lower_bound(bounds_s.begin(), bounds_s.end(), seconds);
  add(route.latency[static_cast<std::size_t>(bound - bounds_s.begin())], 1);
  add(route.latency_sum_ns,
      static_cast<std::uint64_t>(std::max<std::int64_t>(0, request.took.count())));
  add(bytes_, request.bytes);
}

void Metrics::connection_opened() noexcept {
  add(accepted_, 1);
  connections_.fetch_add(1, std::memory_order_relaxed);
}

void Metrics::websocket_opened() noexcept {
  add(websockets_opened_, 1);
  websockets_.fetch_add(1, std::memory_order_relaxed);
}

std::chrono::seconds Metrics::uptime() const noexcept {
  return std::chrono::duration_cast<std::chrono::seconds>(std::chrono::steady_clock::now() -
                                                          started_);
}

void Metrics::append_requests(std::string& text) const {
  append_header(text, "slackwater_http_requests_total", "counter", "Requests answered.");
  for (const auto& [label, route] : routes_) {
    for (std::size_t m = 0; m < methods.size(); ++m) {
      for (std::size_t s = 0; s <= statuses.size(); ++s) {
        const std::uint64_t count = route->requests[m][s].load(std::memory_order_relaxed);
        if (count == 0) continue;
        text += "slackwater_http_requests_total{route=" + in_quotes(label) +
                ",method=" + in_quotes(methods[m]) + ",status=\"" +
                (s < statuses.size() ? std::to_string(statuses[s]) : "other") + "\"} " +
                std::to_string(count) + "\n";
      }
    }
  }
}

void Metrics::append_latencies(std::string& text) const {
  const std::string name = "slackwater_http_request_duration_seconds";
  append_header(text, name, "histogram",
                "From the last byte of a request to the last of its answer.");
  for (const auto& [label, route] : routes_) {
    std::uint64_t count = 0;
    std::string lines;
    for (std::size_t b = 0; b <= bounds_s.size(); ++b) {
      count += route->latency[b].load(std::memory_order_relaxed);
      lines += name + "_bucket{route=" + in_quotes(label) + ",le=\"" +
               (b < bounds_s.size() ? number(bounds_s[b]) : "+Inf") + "\"} " +
               std::to_string(count) + "\n";
    }
    if (count == 0) continue;
    const double sum_s =
        1e-9 * static_cast<double>(route->latency_sum_ns.load(std::memory_order_relaxed));
    text += lines + name + "_sum{route=" + in_quotes(label) + "} " + number(sum_s) + "\n" + name +
            "_count{route=" + in_quotes(label) + "} " + std::to_string(count) + "\n";
  }
}

void Metrics::append_process(std::string& text) const {
  append_metric(text, "slackwater_http_requests_in_flight", "gauge", "Requests being answered.",
                std::to_string(in_flight_.load(std::memory_order_relaxed)));
  append_metric(text, "slackwater_http_connections", "gauge", "Connections open.",
                std::to_string(connections_.load(std::memory_order_relaxed)));
  append_metric(text, "slackwater_http_connections_total", "counter", "Connections accepted.",
                std::to_string(accepted_.load(std::memory_order_relaxed)));
  append_metric(text, "slackwater_http_websockets", "gauge", "WebSockets open.",
                std::to_string(websockets_.load(std::memory_order_relaxed)));
  append_metric(text, "slackwater_http_websockets_total", "counter", "WebSockets opened.",
                std::to_string(websockets_opened_.load(std::memory_order_relaxed)));
  append_metric(text, "slackwater_http_websocket_frames_total", "counter",
                "Messages sent over WebSockets.",
                std::to_string(frames_sent_.load(std::memory_order_relaxed)));
  append_metric(text, "slackwater_http_websocket_dropped_frames_total", "counter",
                "Messages dropped because a client of a WebSocket was slow.",
                std::to_string(frames_dropped_.load(std::memory_order_relaxed)));
  append_metric(text, "slackwater_http_response_bytes_total", "counter", "Bytes of answers sent.",
                std::to_string(bytes_.load(std::memory_order_relaxed)));
  append_metric(text, "process_resident_memory_bytes", "gauge", "Resident memory size in bytes.",
                std::to_string(resident_bytes()));
  append_metric(text, "process_start_time_seconds", "gauge",
                "Start time of the process since unix epoch in seconds.",
                std::to_string(start_time_));
}

std::string Metrics::exposition() const {
  std::string text;
  append_requests(text);
  append_latencies(text);
  append_process(text);
  return text;
}

std::string exposition(const std::vector<Gauge>& gauges) {
  std::string text;
  for (const Gauge& gauge : gauges) {
    if (gauge.values.empty()) continue;
    append_header(text, gauge.name, "gauge", gauge.help);
    for (const auto& [label, value] : gauge.values) {
      text.append(gauge.name).append("{").append(gauge.label).append("=");
      text.append(in_quotes(label)).append("} ").append(number(value)).append("\n");
    }
  }
  return text;
}

Handler metrics_handler(std::shared_ptr<const Metrics> metrics,
                        std::function<std::vector<Gauge>()> gauges) {
  return [metrics = std::move(metrics), gauges = std::move(gauges)](const Request&) {
    Response response;
    response.media_type = "text/plain; version=0.0.4; charset=utf-8";
    response.body = metrics->exposition();
    if (gauges) response.body += exposition(gauges());
    return response;
  };
}

}  // namespace slackwater::api::http
