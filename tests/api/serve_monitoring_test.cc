// `slackwater serve --monitoring` as monitors find it: here, through a proxy, and from an address
// that is not loopback.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <sys/stat.h>

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "data/store/store.h"
#include "tests/support/comes_true.h"
#include "tests/support/contains.h"
#include "tests/support/http_client.h"
#include "tests/support/refusal.h"
#include "tests/support/started_program.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::serve_monitoring_test {
namespace {

using nlohmann::json;

/// Of /health, /health/fresh (503: the store is empty) and /metrics.
using Statuses = std::array<int, 3>;
constexpr Statuses all{200, 503, 200}, refused{403, 403, 403}, absent{404, 404, 404};

const std::string by_token = "Authorization: Bearer monitor-0123456789ab\r\n";
const std::string by_proxy = "X-Forwarded-For: 127.0.0.1\r\n";

/// An IPv4 address of this machine that is not loopback; nothing where it has none.
std::optional<std::string> outer_address() {
  ifaddrs* list = nullptr;
  if (::getifaddrs(&list) != 0) return std::nullopt;
  std::optional<std::string> found;
  for (const ifaddrs* each = list; each != nullptr && !found; each = each->ifa_next) {
    const bool is_up = (each->ifa_flags & IFF_UP) != 0 && (each->ifa_flags & IFF_LOOPBACK) == 0;
    if (!is_up || each->ifa_addr == nullptr || each->ifa_addr->sa_family != AF_INET) continue;
    std::array<char, INET_ADDRSTRLEN> text{};
    const auto& address = reinterpret_cast<const sockaddr_in&>(*each->ifa_addr);
    if (::inet_ntop(AF_INET, &address.sin_addr, text.data(), text.size()) != nullptr)
      found = text.data();
  }
  ::freeifaddrs(list);
  return found;
}

struct ServeMonitoring : testing::Test {
  ServeMonitoring() {
    std::ofstream(folder / "token") << "monitor-0123456789ab\n";
    EXPECT_EQ(::chmod((folder / "token").c_str(), 0600), 0);
    (void)store::Store::open(folder / "store", store::OpenMode::create_or_write);
  }
  void start(const std::vector<std::string>& more) {
    std::vector<std::string> words{"serve",        "--port",         "0",       "--json",
                                   "--token-file", folder / "token", "--store", folder / "store"};
    words.insert(words.end(), more.begin(), more.end());
    program.emplace(start_program(words, {}, folder / "out", folder / "err"));
    ASSERT_TRUE(
        comes_true([&] { return text_in("out").ends_with("\n"); }, std::chrono::seconds(60)))
        << text_in("err");
    port = json::parse(text_in("out")).at("port").get<std::uint16_t>();
  }
  [[nodiscard]] std::string text_in(const char* file) const {
    std::ostringstream text;
    text << std::ifstream(folder / file).rdbuf();
    return text.str();
  }
  [[nodiscard]] HttpReply get(const std::string& target, const std::string& fields = {},
                              const char* at = "127.0.0.1") const {
    return HttpClient(ServerPlace(port, at)).get(target, fields).value_or(HttpReply{});
  }
  [[nodiscard]] Statuses statuses(const std::string& fields = {},
                                  const char* at = "127.0.0.1") const {
    return {get("/health", fields, at).status, get("/health/fresh", fields, at).status,
            get("/metrics", fields, at).status};
  }
  /// The paths of the document that begin with these words.
  [[nodiscard]] json described() const {
    json found = json::object();
    const json document = json::parse(get("/api?f=json").body);
    for (const char* path : {"/health", "/health/fresh", "/metrics"})
      if (document.at("paths").contains(path))
        found[path] = document.at("paths").at(path).at("get").contains("security");
    return found;
  }

  TemporaryFolder folder;
  std::optional<StartedProgram> program;
  std::uint16_t port = 0;
};

TEST_F(ServeMonitoring, IsForEveryoneUnlessToldOtherwise) {
  ASSERT_NO_FATAL_FAILURE(start({}));
  EXPECT_EQ(statuses(), all);
  EXPECT_EQ(statuses(by_proxy), all);
  EXPECT_EQ(described(), json({{"/health", false}, {"/health/fresh", false}, {"/metrics", false}}));
  EXPECT_EQ(program->end(SIGTERM), 0);
}

TEST_F(ServeMonitoring, OfHealthAloneLetsABalancerAskThroughAProxyAndNoMore) {
  ASSERT_NO_FATAL_FAILURE(start({"--monitoring", "health"}));
  EXPECT_EQ(statuses(), all) << "Prometheus on this machine";
  EXPECT_EQ(statuses(by_proxy), (Statuses{200, 503, 403}));
  EXPECT_EQ(statuses(by_proxy + by_token), all);
  EXPECT_EQ(described(), json({{"/health", false}, {"/health/fresh", false}, {"/metrics", true}}));
}

TEST_F(ServeMonitoring, OfThisMachineRefusesProxiesAndCountsTheRefusals) {
  ASSERT_NO_FATAL_FAILURE(start({"--monitoring", "local"}));
  EXPECT_EQ(statuses(), all);
  EXPECT_EQ(statuses(by_proxy), refused);
  EXPECT_EQ(statuses("Forwarded: for=127.0.0.1\r\n"), refused);
  EXPECT_EQ(statuses("Origin: https://evil.example\r\n"), refused);
  EXPECT_EQ(statuses(by_proxy + by_token), all);
  EXPECT_EQ(get("/metrics/", by_proxy).status, 403);
  EXPECT_EQ(get("/collections", by_proxy).status, 200) << "what is served stays open";
  const HttpReply reply = get("/health", by_proxy);
  EXPECT_EQ(reply.field("content-type"), "application/problem+json");
  EXPECT_EQ(json::parse(reply.body).at("instance"), "/health");
  EXPECT_TRUE(contains(get("/metrics").body, R"({route="/metrics",method="GET",status="403"} 4)"));
  EXPECT_EQ(described(), json({{"/health", true}, {"/health/fresh", true}, {"/metrics", true}}));
}

TEST_F(ServeMonitoring, OfThisMachineRefusesOthersOnAnAddressThatTheyReach) {
  const auto outer = outer_address();
  if (!outer) GTEST_SKIP() << "this machine has no address but loopback";
  ASSERT_NO_FATAL_FAILURE(start({"--monitoring", "local", "--address", "0.0.0.0"}));
  EXPECT_EQ(statuses(), all);
  EXPECT_EQ(statuses({}, outer->c_str()), refused) << *outer << ", whatever the Host field says";
  EXPECT_EQ(statuses(by_token, outer->c_str()), all);
}

TEST_F(ServeMonitoring, OfNobodyIsNotServed) {
  ASSERT_NO_FATAL_FAILURE(start({"--monitoring", "nobody"}));
  EXPECT_EQ(statuses(), absent);
  EXPECT_EQ(statuses(by_token), absent);
  EXPECT_EQ(get("/collections").status, 200);
  EXPECT_EQ(described(), json::object());
  EXPECT_FALSE(contains(get("/api?f=html").body, "/metrics"));
}

TEST_F(ServeMonitoring, OfAnotherWordIsRefusedWithThoseThereAre) {
  expect_refusal(run_program({"serve", "--port", "0", "--monitoring", "everybody", "--store",
                              folder / "store"}),
                 2, {"found 'everybody'", "everyone, health, local, nobody"});
  const ProgramResult help = run_program({"serve", "--help"});
  EXPECT_TRUE(contains(help.out, "--monitoring"));
}

}  // namespace
}  // namespace slackwater::tests::serve_monitoring_test
