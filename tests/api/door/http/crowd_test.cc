// Who makes room where all connections are taken.
#include "api/door/http/crowd.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "api/door/http/session.h"

namespace slackwater::tests::crowd_test {
namespace {

using namespace api::http;
using namespace std::chrono_literals;

/// A session that stands as it is told.
struct Standee final : Session {
  Standee(std::string client, std::optional<Standing> standing)
      : client_(std::move(client)), standing_(standing) {}
  void begin() override {}
  void tick(Moment /*now*/) override {}
  std::optional<Standing> standing(Moment /*now*/) const override { return standing_; }
  const std::string& client() const override { return client_; }
  void refuse_newcomer() override {}
  void drain() override {}
  void close() override {}

 private:
  std::string client_;
  std::optional<Standing> standing_;
};

struct Crowd : testing::Test {
  void add(const std::string& client, Wait wait, std::chrono::milliseconds waited,
           std::size_t bytes = 0) {
    sessions.push_back(std::make_shared<Standee>(client, Standing{wait, now - waited, bytes}));
  }
  void add_at_work() { sessions.push_back(std::make_shared<Standee>("a", std::nullopt)); }
  /// Their places in `sessions`.
  [[nodiscard]] std::vector<std::size_t> displaced(std::size_t most) const {
    std::vector<std::size_t> places;
    for (const auto& one : those_to_displace(sessions, Limits{}, now, most))
      places.push_back(static_cast<std::size_t>(std::find(sessions.begin(), sessions.end(), one) -
                                                sessions.begin()));
    return places;
  }
  const Moment now = std::chrono::steady_clock::now();
  std::vector<std::shared_ptr<Session>> sessions;
};

using Places = std::vector<std::size_t>;

TEST_F(Crowd, TheLeastWorthyAndThenTheOldestGoFirst) {
  add("a", Wait::at_rest, 50s);
  add("a", Wait::reads_slowly, 3s);
  add("a", Wait::says_nothing, 200ms);
  add("a", Wait::says_nothing, 9s);
  add("a", Wait::at_rest, 60s);
  EXPECT_EQ(displaced(10), (Places{3, 2, 1, 4, 0}));
  EXPECT_EQ(displaced(2), (Places{3, 2}));
}

TEST_F(Crowd, WhoeverHasMostMakesRoomForTheOthers) {
  add("few", Wait::says_nothing, 9s);
  for (int i = 0; i < 3; ++i) add("many", Wait::says_nothing, 5s - i * 1s);
  EXPECT_EQ(displaced(4), (Places{1, 2, 3, 0}));
}

TEST_F(Crowd, WhoJustCameOrIsAtWorkStays) {
  add_at_work();
  add("a", Wait::says_nothing, 50ms);
  add("a", Wait::at_rest, 500ms);
  EXPECT_TRUE(displaced(10).empty());
}

TEST_F(Crowd, SlowReadersMakeRoomTheLargestFirst) {
  add("a", Wait::reads_slowly, 3s, 10);
  add("a", Wait::reads_slowly, 3s, 100);
  add("a", Wait::at_rest, 30s, 1000);
  EXPECT_EQ(slow_readers(sessions, 50), (std::vector{sessions[1]}));
  EXPECT_EQ(slow_readers(sessions, 105), (std::vector{sessions[1], sessions[0]}));
  EXPECT_EQ(slow_readers(sessions, 5000).size(), 2U);
}

}  // namespace
}  // namespace slackwater::tests::crowd_test
