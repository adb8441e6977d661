// `slackwater serve` under wrk, 16 connections on the cores that serve: a position query of 50
// levels at one instant as CoverageJSON, requests per second and the 99th percentile of the
// latency. Its values are compared with the field of the same forecast first. Another service is
// measured with
//   SLACKWATER_HTTP_URL=http://127.0.0.1:<port>/<path>;
// SLACKWATER_HTTP_SECONDS is how long (default 5).
#include <netinet/in.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "fields/service/field.h"
#include "ingest/cf/forecast/forecast_file.h"
#include "tests/bench/bench_report.h"
#include "tests/bench/http_load.h"
#include "tests/bench/synthetic_store.h"
#include "tests/bench/timed_child.h"
#include "tests/support/http_client.h"
#include "tests/support/program.h"

namespace {

using namespace slackwater;
using namespace slackwater::bench;

constexpr double target_requests_per_s = 5000;
constexpr double target_p99_ms = 5;
std::string environment(const char* name, const std::string& otherwise) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : otherwise;
}

/// A port that is free at this moment.
std::uint16_t free_port() {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  const bool bound = ::bind(socket, reinterpret_cast<sockaddr*>(&address), size) == 0 &&
                     ::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size) == 0;
  ::close(socket);
  if (!bound) throw std::runtime_error("no free port");
  return ntohs(address.sin_port);
}

/// The program serving a store with one forecast; ended with SIGTERM.
class Service {
 public:
  Service() : port_(free_port()), file_(store_.file("forecast.nc")) {
    slackwater_or_throw(store_.forecast_arguments(store_.store(), file_));
    process_ = tests::start_program(
        {"serve", "--store", store_.store().string(), "--port", std::to_string(port_)});
  }
  ~Service() {
    ::kill(process_, SIGTERM);
    tests::wait_for_program(process_);
  }
  Service(const Service&) = delete;
  Service& operator=(const Service&) = delete;

  /// 50 levels, an instant between two stamps.
  [[nodiscard]] std::string url(const Field& field) const {
    const Snapshot& snapshot = field.snapshot();
    const GeoPoint& point = snapshot.columns.front().point;
    char text[200];
    std::snprintf(text, sizeof text,
                  "http://127.0.0.1:%d/collections/currents/position?coords=POINT(%.6f%%20%.6f)"
                  "&datetime=%s&z=R50/0/0.6&f=CoverageJSON",
                  port_, point.longitude_deg(), point.latitude_deg(),
                  format_utc(time_in(snapshot)).c_str());
    return text;
  }
  [[nodiscard]] Field field() const {
    return Field(std::make_shared<const Snapshot>(ingest::read_forecast(file_)));
  }
  [[nodiscard]] static UtcTime time_in(const Snapshot& snapshot) {
    return snapshot.time.front() + std::chrono::minutes(617);
  }

 private:
  SyntheticStore store_;
  std::uint16_t port_;
  std::filesystem::path file_;
  pid_t process_ = -1;
};

/// Empty where the answer holds what the field holds, to six digits; else what is wrong.
std::string fault_of(const std::string& body, const Field& field) {
  const nlohmann::json answer = nlohmann::json::parse(body);
  const GeoPoint& point = field.snapshot().columns.front().point;
  const auto& depths = answer.at("domain").at("axes").at("z").at("values");
  if (depths.size() != 50) return std::to_string(depths.size()) + " levels";
  for (std::size_t k = 0; k < depths.size(); ++k) {
    const CurrentSample expected =
        field.current({point.longitude_deg(), point.latitude_deg(), depths[k].get<double>(),
                       Service::time_in(field.snapshot())});
    const auto& found = answer.at("ranges").at("eastward_sea_water_velocity").at("values").at(k);
    if (found.is_null() == has_value(expected.status)) return "a value where there is none";
    if (!found.is_null() && std::abs(found.get<double>() - expected.velocity_m_s.real()) > 2e-6)
      return "another value at level " + std::to_string(k);
  }
  return {};
}

/// Waits up to half a minute for a server that is being started.
std::optional<tests::HttpReply> first_answer(const LocalUrl& url) {
  for (int i = 0; i < 300; ++i) {
    try {
      return tests::HttpClient(url.port).get(url.target);
    } catch (const std::runtime_error&) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
  }
  return std::nullopt;
}

bool check_answer(BenchReport& report, const LocalUrl& url, const Field* field) {
  const auto reply = first_answer(url);
  const bool answered = reply && reply->status == 200 && !reply->body.empty() &&
                        reply->field("content-encoding").empty();
  const std::string fault = answered && field != nullptr ? fault_of(reply->body, *field) : "";
  report.answer("http", answered && fault.empty(),
                !reply ? "no answer"
                       : "status " + std::to_string(reply->status) + ", " +
                             std::to_string(reply->body.size()) + " bytes of " +
                             reply->field("content-type") + (fault.empty() ? "" : ": ") + fault);
  return answered && fault.empty();
}

void bench_server(BenchReport& report, const std::string& url, const Field* field) {
  if (!check_answer(report, parse_local_url(url), field)) return;
  const int seconds =
      report.options().check_only ? 1 : std::stoi(environment("SLACKWATER_HTTP_SECONDS", "5"));
  const auto load = load_with_wrk(url, seconds);
  if (!load) {
    report.skipped("http", "wrk is not installed (cmake/debian-packages-test.txt)");
    return;
  }
  report.answer("http under load", load->bad_answers + load->socket_errors == 0,
                std::to_string(load->bad_answers) + " bad answers, " +
                    std::to_string(load->socket_errors) + " socket errors");
  if (report.options().check_only) return;
  report.figure({"requests, 16 connections",
                 "1/s",
                 {load->requests_per_s},
                 std::nullopt,
                 url,
                 target_requests_per_s});
  report.figure({"  99th percentile of the latency", "ms", {load->p99_ms}, target_p99_ms, ""});
  report.figure({"  median of the latency", "ms", {load->p50_ms}, std::nullopt, ""});
}

}  // namespace

int main(int argc, char** argv) {
  BenchReport report(bench_options(argc, argv));
  try {
    const std::string url = environment("SLACKWATER_HTTP_URL", "");
    if (!url.empty()) {
      bench_server(report, url, nullptr);
    } else {
      const Service service;
      const Field field = service.field();
      bench_server(report, service.url(field), &field);
    }
  } catch (const std::exception& problem) {
    report.answer("http", false, problem.what());
  }
  return report.exit_code();
}
