#include <dirent.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <deque>
#include <random>
#include <thread>
#include <vector>

#include "tests/api/door/http/served.h"
#include "tests/support/comes_true.h"

// Clients that are slow, wrong, greedy or gone: each is told why where it can be told, and nobody
// else notices.

namespace slackwater::tests::hostile_client_test {
namespace {

using namespace std::chrono_literals;
using api::http::ServerOptions;

/// What the server answers to these bytes on a fresh connection.
std::optional<HttpReply> answer_to(const Served& served, const std::string& bytes) {
  HttpClient client = served.client();
  client.send(bytes);  // it may close before all has gone
  return client.receive();
}

int status_of_answer(const Served& served, const std::string& bytes) {
  const auto reply = answer_to(served, bytes);
  if (!reply) return 0;
  EXPECT_EQ(reply->field("content-type"), "application/problem+json");
  return reply->status;
}

void expect_prompt(const Served& served) {
  const auto from = std::chrono::steady_clock::now();
  const auto reply = served.get("/short");
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->status, 200);
  EXPECT_LT(std::chrono::steady_clock::now() - from, 2s);
}

std::string header_of(const std::string& fields) {
  return "GET /short HTTP/1.1\r\nHost: localhost\r\n" + fields + "\r\n";
}

TEST(HostileClient, IsToldWhatIsNoHttp) {
  const Served served;
  const std::vector<std::string> nonsense{
      "GARBAGE\r\n\r\n",
      "GET\r\n\r\n",
      "GET /short\r\n\r\n",
      "GET  /short HTTP/1.1\r\nHost: localhost\r\n\r\n",
      "\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03 a TLS hello\r\n\r\n",
      header_of("No colon\r\n"),
      header_of("Name : space before the colon\r\n"),
      header_of("Content-Length: -1\r\n"),
      header_of("Content-Length: 99999999999999999999\r\n"),
      header_of("Content-Length: 3\r\nTransfer-Encoding: chunked\r\n"),
      header_of("Host: another\r\n"),
      "GET /short HTTP/1.1\r\n\r\n",
      "GET short HTTP/1.1\r\nHost: localhost\r\n\r\n",
      "POST /write HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\nzz\r\n",
  };
  for (const std::string& bytes : nonsense)
    EXPECT_EQ(status_of_answer(served, bytes), 400) << bytes;
  EXPECT_EQ(status_of_answer(served, "GET / HTTP/3.0\r\nHost: a\r\n\r\n"), 505);
  EXPECT_EQ(status_of_answer(served, "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n"), 505);
  expect_prompt(served);
}

TEST(HostileClient, PathTricksStayOutside) {
  const Served served;
  for (const std::string path :
       {"/../etc/passwd", "/echo/..", "/echo/%2e%2e", "/echo/%2F", "/echo/a%5cb", "/echo/%00",
        "/echo/%zz", "/echo/%", "/echo/%0d%0aX-Evil:1"}) {
    EXPECT_EQ(status_of_answer(served, "GET " + path + " HTTP/1.1\r\nHost: localhost\r\n\r\n"), 400)
        << path;
  }
  const auto once = served.get("/echo/%2525");
  ASSERT_TRUE(once);
  EXPECT_EQ(once->body, "%25?") << "decoded once";
}

TEST(HostileClient, TooLongIsRefusedBeforeItIsRead) {
  const Served served;
  const std::string long_url =
      "GET /" + std::string(16 * 1024, 'a') + " HTTP/1.1\r\nHost: h\r\n\r\n";
  EXPECT_EQ(status_of_answer(served, long_url), 414);
  EXPECT_EQ(status_of_answer(served, "GET /" + std::string(1'000'000, 'a')), 414);
  EXPECT_EQ(status_of_answer(served, header_of("X: " + std::string(100'000, 'x') + "\r\n")), 431);
  EXPECT_EQ(status_of_answer(served,
                             "POST /write HTTP/1.1\r\nHost: localhost\r\nContent-Length: "
                             "1048577\r\n\r\n"),
            413);
  std::string chunked =
      "POST /write HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\n";
  for (int i = 0; i < 40; ++i) chunked += "8000\r\n" + std::string(0x8000, 'x') + "\r\n";
  EXPECT_EQ(status_of_answer(served, chunked), 413);
  const std::string most = std::string(1 << 20, 'x');
  const auto fits = answer_to(served,
                              "POST /write HTTP/1.1\r\nHost: localhost\r\nContent-Length: 1048576"
                              "\r\n\r\n" +
                                  most);
  ASSERT_TRUE(fits);
  EXPECT_EQ(fits->body, "1048576");
}

TEST(HostileClient, FloodsOfFieldsAreCutShort) {
  const Served served;
  const auto fields = [](int count) {
    std::string lines;
    for (int i = 0; i < count; ++i) lines.append("X").append(std::to_string(i)).append(": y\r\n");
    return header_of(lines);
  };
  const auto most = answer_to(served, fields(99));
  ASSERT_TRUE(most);
  EXPECT_EQ(most->status, 200) << "with Host a hundred: the limit";
  EXPECT_EQ(status_of_answer(served, fields(100)), 431);
  EXPECT_EQ(status_of_answer(served, fields(100'000)), 431);
  expect_prompt(served);
}

TEST(HostileClient, OneThatSpellsItsRequestOutIsCutOffWhileOthersAreServed) {
  ServerOptions options;
  options.limits.read_time = 600ms;
  const Served served(example_router(), options);
  std::vector<HttpClient> slow;
  for (int i = 0; i < 20; ++i) slow.push_back(served.client());
  HttpClient silent = served.client();
  const auto from = std::chrono::steady_clock::now();
  const std::string request = header_of({});
  for (std::size_t i = 0; i < 8; ++i) {
    for (HttpClient& client : slow) client.send(request.substr(i, 1));
    expect_prompt(served);
    std::this_thread::sleep_for(100ms);
  }
  for (HttpClient& client : slow) {
    const auto reply = client.receive();
    ASSERT_TRUE(reply);
    EXPECT_EQ(reply->status, 408);
    EXPECT_TRUE(client.is_closed_within(5s));
  }
  EXPECT_TRUE(silent.is_closed_within(5s));
  EXPECT_GE(std::chrono::steady_clock::now() - from, 600ms);
}

TEST(HostileClient, OneThatDoesNotReadItsAnswerIsCutOff) {
  ServerOptions options;
  options.limits.write_time = 400ms;
  options.metrics = std::make_shared<api::http::Metrics>(std::vector<std::string>{});
  const Served served(
      [](const api::http::Request&) {
        return text_response(std::string(30'000'000, 'x'), "application/netcdf");
      },
      options);
  HttpClient deaf = served.client(4096);
  ASSERT_TRUE(deaf.send(header_of({})));
  const auto open = [&] {
    return options.metrics->exposition().find("slackwater_http_connections 1\n") !=
           std::string::npos;
  };
  std::this_thread::sleep_for(200ms);
  EXPECT_TRUE(open());
  for (int i = 0; i < 200 && open(); ++i) std::this_thread::sleep_for(50ms);
  EXPECT_FALSE(open());
}

// A reader that is fresh keeps its answer, and who would need the memory is told to come back; one
// that takes nothing in makes room.
TEST(HostileClient, LargeAnswersThatNobodyReadsDoNotFillTheMemory) {
  ServerOptions options;
  options.limits.answer_bytes = 40'000'000;
  api::http::Router router = example_router();
  router.add("GET", "/large", [](const api::http::Request&) {
    return text_response(std::string(30'000'000, 'x'), "application/netcdf");
  });
  const Served served(router, options);
  // On a busy machine two seconds may pass between the two: then once more.
  std::optional<HttpClient> deaf;
  std::optional<HttpReply> second;
  for (int i = 0; i < 10 && (!second || second->status == 200); ++i) {
    deaf.emplace(served.client(4096));
    ASSERT_TRUE(deaf->send("GET /large HTTP/1.1\r\nHost: a\r\n\r\n"));
    std::this_thread::sleep_for(500ms);
    second = served.get("/large");
  }
  ASSERT_TRUE(second);
  EXPECT_EQ(second->status, 503) << "60 MB would be held";
  EXPECT_EQ(second->field("retry-after"), "1");
  EXPECT_EQ(served.get("/short")->status, 200) << "small answers pass";
  for (int i = 0; i < 200 && second->status != 200; ++i) {
    std::this_thread::sleep_for(50ms);
    second = served.get("/large");
    ASSERT_TRUE(second);
  }
  EXPECT_EQ(second->status, 200) << "the deaf one has made room";
  EXPECT_EQ(second->body.size(), 30'000'000U);
}

// Work that nobody waits for any more is not begun, or learns that it need not go on.
TEST(HostileClient, WorkForAClientThatResetsIsNotDone) {
  std::atomic<int> begun = 0, told = 0;
  api::http::ServerOptions options;
  options.threads = 1;
  api::http::Router router = example_router();
  router.add("GET", "/slow", [&](const api::http::Request& request) {
    ++begun;
    for (int i = 0; i < 200 && !request.stop.stop_requested(); ++i)
      std::this_thread::sleep_for(10ms);
    told += request.stop.stop_requested() ? 1 : 0;
    return text_response("{}");
  });
  const Served served(router, options);
  std::vector<HttpClient> crowd;
  for (int i = 0; i < 64; ++i) {
    crowd.push_back(served.client());
    crowd.back().send("GET /slow HTTP/1.1\r\nHost: a\r\n\r\n");
  }
  ASSERT_TRUE(comes_true([&] { return begun > 0; }));
  for (HttpClient& client : crowd) client.reset();
  expect_prompt(served);
  EXPECT_LT(begun, 10) << "of 64";
  EXPECT_GE(told, 1);
}

// One that has no more to say still waits for its answer.
TEST(HostileClient, AHalfClosedConnectionIsAnswered) {
  api::http::Router router = example_router();
  router.add("GET", "/slow", [](const api::http::Request& request) {
    std::this_thread::sleep_for(200ms);
    return text_response(request.stop.stop_requested() ? "given up" : "answered");
  });
  const Served served(router);
  HttpClient client = served.client();
  client.send("GET /slow HTTP/1.1\r\nHost: a\r\n\r\n");
  client.close_for_writing();
  const auto reply = client.receive();
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->body, "answered");
}

TEST(HostileClient, OneThatIsSilentBetweenRequestsIsClosed) {
  ServerOptions options;
  options.limits.idle_time = 300ms;
  const Served served(example_router(), options);
  HttpClient client = served.client();
  ASSERT_TRUE(client.get("/short"));
  EXPECT_TRUE(client.is_closed_within(5s));
}

TEST(HostileClient, ResetsAtAnyMomentHarmNobody) {
  const Served served([](const api::http::Request&) {
    std::this_thread::sleep_for(1ms);
    return text_response(std::string(100'000, 'x'), "application/netcdf");
  });
  for (int i = 0; i < 400; ++i) {
    HttpClient client = served.client();
    if (i % 4 >= 1) client.send(header_of({}).substr(0, i % 4 == 1 ? 10 : std::string::npos));
    if (i % 4 == 3) std::this_thread::sleep_for(500us);
    client.reset();
  }
  EXPECT_TRUE(served.get("/"));
}

/// Connections that all have been answered once and stay.
std::vector<int> statuses_of_crowd(const Served& served, std::vector<HttpClient>& crowd,
                                   int count) {
  std::vector<int> statuses;
  for (int i = 0; i < count; ++i) {
    crowd.push_back(served.client());
    crowd.back().send(header_of({}));
  }
  for (HttpClient& client : crowd) {
    const auto reply = client.receive();
    statuses.push_back(reply ? reply->status : 0);
  }
  return statuses;
}

TEST(HostileClient, BeyondTheLimitOfConnectionsNewcomersAreToldToComeBack) {
  ServerOptions options;
  options.limits.patience = 60s;
  options.limits.connections = 256;
  const Served served(example_router(), options);
  std::vector<HttpClient> crowd;
  const std::vector<int> statuses = statuses_of_crowd(served, crowd, 300);
  EXPECT_EQ(std::count(statuses.begin(), statuses.end(), 200), 256);
  EXPECT_EQ(std::count(statuses.begin(), statuses.end(), 503), 44);
  crowd.clear();
  for (int i = 0; i < 100; ++i) {  // the server notices at its next turn
    if (served.get("/short")->status == 200) break;
    std::this_thread::sleep_for(10ms);
  }
  expect_prompt(served);
}

TEST(HostileClient, ACrowdThatHoldsEveryConnectionIsDisplaced) {
  ServerOptions options;
  options.limits.patience = 100ms;
  options.limits.connections = 256;
  const Served served(example_router(), options);
  std::vector<HttpClient> squatters;
  for (int i = 0; i < 256; ++i) squatters.push_back(served.client());
  for (int i = 0; i < 128; ++i) squatters[static_cast<std::size_t>(i)].send("GET /");
  std::this_thread::sleep_for(300ms);
  for (int i = 0; i < 20; ++i) expect_prompt(served);
}

// Half-requests that are renewed all the time displace each other, and neither those who ask nor
// those who rest between two questions.
TEST(HostileClient, HalfRequestsThatAreRenewedShutNobodyOut) {
  ServerOptions options;
  options.limits.connections = 64;
  options.limits.patience = 500ms;
  const Served served(example_router(), options);
  HttpClient kept = served.client();
  ASSERT_TRUE(kept.get("/short"));
  std::atomic<bool> goes_on = true;
  std::thread attack([&] {
    std::deque<HttpClient> half;
    while (goes_on) {
      half.push_back(served.client());
      half.back().send("GET /");
      if (half.size() > 300) half.pop_front();
      std::this_thread::sleep_for(2ms);
    }
  });
  int answered = 0;
  for (int i = 0; i < 100; ++i) {
    const auto reply = served.get("/short");
    answered += reply && reply->status == 200 ? 1 : 0;
    if (i % 10 == 0) EXPECT_TRUE(kept.get("/short")) << i;
    std::this_thread::sleep_for(10ms);
  }
  goes_on = false;
  attack.join();
  EXPECT_GE(answered, 99);
}

std::size_t open_descriptors() {
  std::size_t count = 0;
  DIR* folder = ::opendir("/proc/self/fd");
  while (::readdir(folder) != nullptr) ++count;
  ::closedir(folder);
  return count;
}

TEST(HostileClient, AThousandConnectionsLeaveNoDescriptorBehind) {
  const std::size_t before = open_descriptors();
  {
    const Served served;
    const std::size_t serving = open_descriptors();
    for (int i = 0; i < 1000; ++i) {
      HttpClient client = served.client();
      if (i % 3 == 0) client.send("GARBAGE\r\n\r\n");
      if (i % 3 == 1) {
        EXPECT_TRUE(client.get("/short").has_value());
      }
      if (i % 5 == 0) client.reset();
    }
    for (int i = 0; i < 100 && open_descriptors() > serving; ++i) std::this_thread::sleep_for(50ms);
    EXPECT_EQ(open_descriptors(), serving);
  }
  EXPECT_EQ(open_descriptors(), before);
}

TEST(HostileClient, WithoutDescriptorsLeftItWaitsAndAcceptsAgain) {
  const Served served;
  rlimit old{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &old), 0);
  const rlimit few{64 + open_descriptors(), old.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &few), 0);
  std::vector<int> taken;
  for (int next = ::dup(0); next >= 0; next = ::dup(0)) taken.push_back(next);
  ::close(taken.back());
  taken.pop_back();
  HttpClient client = served.client();  // takes the last one: there is none for its other end
  ASSERT_TRUE(client.send(header_of({})));
  EXPECT_FALSE(client.receive(true, 200ms));
  for (const int descriptor : taken) ::close(descriptor);
  EXPECT_TRUE(client.receive());
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &old), 0);
  expect_prompt(served);
}

/// A valid request with some of its bytes changed, left out or doubled.
std::string mutated(const std::string& request, std::mt19937& random) {
  std::string bytes = request;
  const std::size_t changes = 1 + random() % 4;
  for (std::size_t i = 0; i < changes; ++i) {
    const std::size_t at = random() % bytes.size();
    switch (random() % 3) {
      case 0:
        bytes[at] = static_cast<char>(random() % 256);
        break;
      case 1:
        bytes.erase(at, 1 + random() % 3);
        break;
      default:
        bytes.insert(at, bytes.substr(at, 1 + random() % 20));
    }
  }
  return bytes;
}

TEST(HostileClient, NoMutatedRequestEndsTheServer) {
  const Served served;
  const std::string request =
      "POST /echo/a%20b?c=d HTTP/1.1\r\nHost: localhost\r\nAccept-Encoding: gzip;q=0.5, *;q=0\r\n"
      "If-None-Match: W/\"a\", *\r\nTransfer-Encoding: chunked\r\nConnection: keep-alive\r\n\r\n"
      "4\r\nwind\r\n0\r\n\r\n";
  std::mt19937 random(20250310);
  for (int i = 0; i < 3000; ++i) {
    const std::string bytes = mutated(request, random);
    HttpClient client = served.client();
    client.send(bytes);
    client.close_for_writing();
    const auto reply = client.receive();
    ASSERT_TRUE(reply) << "no answer to: " << bytes;
    EXPECT_LT(reply->status, 506);
    EXPECT_NE(reply->status, 500) << bytes;
  }
  expect_prompt(served);
}

TEST(HostileClient, AskingForAnotherProtocolGetsThisOne) {
  const Served served;
  HttpClient client = served.client();
  const auto reply = client.get("/short", "Connection: Upgrade\r\nUpgrade: websocket\r\n");
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->status, 200);
  const auto goes_on = client.get("/short", "Expect: 100-continue\r\n");
  ASSERT_TRUE(goes_on);
  EXPECT_EQ(goes_on->status, 200);
}

}  // namespace
}  // namespace slackwater::tests::hostile_client_test
