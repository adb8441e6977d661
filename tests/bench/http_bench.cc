// The HTTP server under wrk, 16 connections on the cores that serve: requests per second and the
// 99th percentile of the latency. By default the server of api/http with a handler that hands out
// 6 kB, alone in this process. Another is measured with
//   SLACKWATER_HTTP_URL=http://127.0.0.1:<port>/<path>   that is running already, or is started by
//   SLACKWATER_HTTP_SERVE="<command line>"               and ended afterwards;
// SLACKWATER_HTTP_SECONDS is how long (default 5).
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <exception>
#include <memory>
#include <stdexcept>
#include <thread>

#include "api/http/metrics.h"
#include "api/http/router.h"
#include "api/http/server.h"
#include "tests/bench/bench_report.h"
#include "tests/bench/http_load.h"
#include "tests/support/http_client.h"

namespace {

using namespace slackwater;
using namespace slackwater::bench;

constexpr double target_requests_per_s = 5000;
constexpr double target_p99_ms = 5;
constexpr const char* own_target = "/collections/currents/position";

std::string environment(const char* name, const std::string& otherwise) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : otherwise;
}

/// 6 kB of the numbers that a profile of 50 levels has.
std::string own_body() {
  std::string body = "{\"values\": [0";
  for (int i = 1; body.size() < 6000; ++i) body += ", 0." + std::to_string(123456 + 7919 * i);
  return body + "]}\n";
}

std::unique_ptr<api::http::Server> own_server() {
  using namespace api::http;
  Router router;
  router.add("GET", own_target, [body = own_body()](const Request&) {
    Response response;
    response.media_type = "application/prs.coverage+json";
    response.body = body;
    response.max_age_s = 60;
    return response;
  });
  ServerOptions options;
  options.metrics = std::make_shared<Metrics>(router.labels());
  auto server = std::make_unique<Server>(options, router);
  server->start();
  return server;
}

/// A server that is started by its command line and ended with SIGTERM.
class ForeignServer {
 public:
  explicit ForeignServer(const std::string& command) {
    std::string line = "exec " + command;
    std::string shell = "sh";
    std::string option = "-c";
    char* argv[] = {shell.data(), option.data(), line.data(), nullptr};
    if (::posix_spawnp(&process_, "sh", nullptr, nullptr, argv, environ) != 0) {
      throw std::runtime_error("cannot start " + command);
    }
  }
  ~ForeignServer() {
    ::kill(process_, SIGTERM);
    ::waitpid(process_, nullptr, 0);
  }
  ForeignServer(const ForeignServer&) = delete;
  ForeignServer& operator=(const ForeignServer&) = delete;

 private:
  pid_t process_ = -1;
};

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

bool check_answer(BenchReport& report, const LocalUrl& url, const std::string& expected) {
  const auto reply = first_answer(url);
  const bool right = reply && reply->status == 200 && !reply->body.empty() &&
                     reply->field("content-encoding").empty() &&
                     (expected.empty() || reply->body == expected);
  report.answer("http", right,
                !reply ? "no answer"
                       : "status " + std::to_string(reply->status) + ", " +
                             std::to_string(reply->body.size()) + " bytes of " +
                             reply->field("content-type"));
  return right;
}

void bench_server(BenchReport& report, const std::string& url, const std::string& expected) {
  if (!check_answer(report, parse_local_url(url), expected)) return;
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
    const std::string command = environment("SLACKWATER_HTTP_SERVE", "");
    std::unique_ptr<ForeignServer> foreign;
    if (!command.empty()) foreign = std::make_unique<ForeignServer>(command);
    if (!url.empty()) {
      bench_server(report, url, "");
    } else {
      const auto server = own_server();
      bench_server(report, "http://127.0.0.1:" + std::to_string(server->port()) + own_target,
                   own_body());
    }
  } catch (const std::exception& problem) {
    report.answer("http", false, problem.what());
  }
  return report.exit_code();
}
