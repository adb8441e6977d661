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
  Standee(std::string client, std::optional<Standing> standing, std::size_t bytes)
      : client_(std::move(client)), standing_(standing), bytes_(bytes) {}
  void begin() override {}
  void tick(Moment /*now*/) override {}
  std::optional<Standing> standing(Moment /*now*/) const override { return standing_; }
  std::size_t answer_bytes() const override { return bytes_; }
  const std::string& client() const override { return client_; }
  void refuse_newcomer() override {}
  void drain() override {}
  void close() override {}

 private:
  std::string client_;
  std::optional<Standing> standing_;
  std::size_t bytes_;
};

struct Crowd : testing::Test {
  void add(const std::string& client, Wait wait, std::chrono::milliseconds waited,
           std::size_t bytes = 0) {
    sessions.push_back(std::make_shared<Standee>(client, Standing{wait, now - waited}, bytes));
  }
  void add_at_work(const std::string& client = "a", std::size_t bytes = 0) {
    sessions.push_back(std::make_shared<Standee>(client, std::nullopt, bytes));
  }
  using Sessions = std::vector<std::shared_ptr<Session>>;
  [[nodiscard]] std::vector<std::size_t> places_of(const Sessions& some) const {
    std::vector<std::size_t> places;
    for (const auto& one : some)
      places.push_back(static_cast<std::size_t>(std::find(sessions.begin(), sessions.end(), one) -
                                                sessions.begin()));
    return places;
  }
  /// Their places in `sessions`.
  [[nodiscard]] std::vector<std::size_t> displaced(std::size_t most) const {
    return places_of(those_to_displace(sessions, Limits{}, now, most));
  }
  /// The same of those that are cut off for an answer where all may hold 1200 bytes.
  [[nodiscard]] std::vector<std::size_t> cut_off(const std::string& client,
                                                 std::size_t bytes) const {
    Limits limits;
    limits.answer_bytes = 1200;
    return places_of(those_to_cut_off(sessions, client, bytes, limits, now));
  }
  const Moment now = std::chrono::steady_clock::now();
  Sessions sessions;
};

using Places = std::vector<std::size_t>;

TEST_F(Crowd, TheLeastWorthyAndThenTheOldestGoFirst) {
  add("a", Wait::at_rest, 50s);
  add("a", Wait::reads_slowly, 3s);
  add("a", Wait::says_nothing, 200ms);
  add("a", Wait::says_nothing, 9s);
  add("a", Wait::at_rest, 60s);
  add("a", Wait::has_said_all, 10ms);
  EXPECT_EQ(displaced(10), (Places{3, 2, 1, 5, 4, 0}));
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
  add("a", Wait::reads_slowly, 3s, 300);
  add("a", Wait::reads_slowly, 3s, 500);
  add_at_work("a", 400);
  EXPECT_EQ(cut_off("a", 0), Places{});
  EXPECT_EQ(cut_off("a", 400), (Places{1}));
  EXPECT_EQ(cut_off("a", 600), (Places{1, 0}));
  EXPECT_EQ(cut_off("a", 5000), (Places{1, 0})) << "who reads well stays";
}

TEST_F(Crowd, WhoHoldsMoreThanItsShareMakesRoomForWhoHoldsLess) {
  add_at_work("greedy", 400);
  add_at_work("greedy", 500);
  add_at_work("modest", 300);
  EXPECT_EQ(cut_off("newcomer", 400), (Places{1})) << "a third is its share";
  EXPECT_EQ(cut_off("newcomer", 401), Places{}) << "more than its share";
  EXPECT_EQ(cut_off("modest", 300), (Places{1})) << "of two, a half is each one's";
  EXPECT_EQ(cut_off("greedy", 100), Places{}) << "it has its share";
}

TEST_F(Crowd, NobodyIsBroughtBelowItsShare) {
  add_at_work("a", 600);
  add_at_work("b", 600);
  EXPECT_EQ(cut_off("a", 100), Places{});
  EXPECT_EQ(cut_off("c", 400), (Places{0})) << "600 of 400";
}

}  // namespace
}  // namespace slackwater::tests::crowd_test
