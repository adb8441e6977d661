// Threads and connections are shared between clients, whoever asks for more.
#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "api/door/http/worker_pool.h"
#include "tests/api/door/http/served.h"
#include "tests/support/comes_true.h"

namespace slackwater::tests::shares_test {
namespace {

using namespace std::chrono_literals;

/// Something that all wait for.
class Gate {
 public:
  void open() { is_open_ = true; }
  /// Ten seconds at most, so that a test that fails ends.
  void pass() const {
    (void)comes_true([this] { return is_open_.load(); }, 10s);
  }

 private:
  std::atomic<bool> is_open_ = false;
};

TEST(Shares, ClientsTakeTurnsAtAThread) {
  Gate gate;
  std::string order;
  {
    api::http::WorkerPool pool(1);
    std::atomic<bool> is_begun = false, is_done = false;
    pool.submit("greedy", [&] {
      is_begun = true;
      gate.pass();
    });
    ASSERT_TRUE(comes_true([&] { return is_begun.load(); }));
    for (const char of : {'1', '2', '3', '4'}) pool.submit("greedy", [&order, of] { order += of; });
    for (const char of : {'a', 'b'}) pool.submit("modest", [&order, of] { order += of; });
    pool.submit("other", [&order] { order += 'x'; });
    pool.submit("greedy", [&] { is_done = true; });
    gate.open();
    ASSERT_TRUE(comes_true([&] { return is_done.load(); }));
  }
  EXPECT_EQ(order, "1ax2b34");
}

TEST(Shares, AThreadThatIsStoppedForgetsWhatHasNotBegun) {
  std::atomic<int> done = 0;
  Gate gate;
  api::http::WorkerPool pool(1);
  std::atomic<bool> is_begun = false;
  pool.submit("a", [&] {
    is_begun = true;
    gate.pass();
    ++done;
  });
  ASSERT_TRUE(comes_true([&] { return is_begun.load(); }));
  for (int i = 0; i < 10; ++i) pool.submit(std::to_string(i), [&] { ++done; });
  std::thread opener([&] {
    std::this_thread::sleep_for(50ms);
    gate.open();
  });
  pool.stop();
  opener.join();
  EXPECT_EQ(done, 1);
}

/// GET /slow takes 50 ms, or less where nobody waits for it any more.
api::http::Router with_slow_answers() {
  api::http::Router router = example_router();
  router.add("GET", "/slow", [](const api::http::Request& request) {
    for (int i = 0; i < 50 && !request.stop.stop_requested(); ++i) std::this_thread::sleep_for(1ms);
    return text_response("{}");
  });
  return router;
}

const std::string slow_request = "GET /slow HTTP/1.1\r\nHost: a\r\n\r\n";

// Two hundred of another client's requests would be ten seconds.
TEST(Shares, AHeapOfRequestsOfOneClientKeepsNoOtherWaiting) {
  api::http::ServerOptions options;
  options.threads = 1;
  const Served served(with_slow_answers(), options);
  std::vector<HttpClient> heap;
  for (int i = 0; i < 200; ++i) {
    heap.push_back(served.client_from("127.0.0.2"));
    heap.back().send(slow_request);
  }
  ASSERT_TRUE(heap.front().receive());
  HttpClient modest = served.client_from("127.0.0.3");
  const auto from = std::chrono::steady_clock::now();
  for (int i = 0; i < 3; ++i) {
    const auto reply = modest.get("/short");
    ASSERT_TRUE(reply);
    EXPECT_EQ(reply->status, 200);
  }
  EXPECT_LT(std::chrono::steady_clock::now() - from, 2s);
}

// Clients that closed their side after they asked hold no place that others need.
TEST(Shares, WhoCanSayNoMoreMakesRoom) {
  api::http::ServerOptions options;
  options.threads = 1;
  options.limits.connections = 32;
  const Served served(with_slow_answers(), options);
  std::vector<HttpClient> gone;
  for (int i = 0; i < 32; ++i) {
    gone.push_back(served.client_from("127.0.0.2"));
    gone.back().send(slow_request);
    gone.back().close_for_writing();
  }
  ASSERT_TRUE(gone.front().receive());
  std::vector<HttpClient> newcomers;
  for (int i = 0; i < 8; ++i) {
    newcomers.push_back(served.client_from("127.0.0.3"));
    newcomers.back().send("GET /short HTTP/1.1\r\nHost: a\r\n\r\n");
  }
  for (HttpClient& newcomer : newcomers) {
    const auto reply = newcomer.receive();
    ASSERT_TRUE(reply);
    EXPECT_EQ(reply->status, 200);
  }
}

}  // namespace
}  // namespace slackwater::tests::shares_test
