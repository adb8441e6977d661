// What people do is in the store while they do it, and stays there.
#include "api/door/people/action_keeper.h"

#include <gtest/gtest.h>

#include "data/store/database.h"
#include "tests/support/comes_true.h"
#include "tests/support/contains.h"
#include "tests/support/error_of.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::action_keeper_test {
namespace {

using store::OpenMode;
using store::SessionAction;
using store::Store;

const UtcTime begun = parse_utc("2026-05-01T06:00:00Z");

SessionAction action(std::uint64_t number) {
  return {number,
          begun,
          1.25,
          25,
          3,
          "Zo\xC3\xAB, \"Z\"",
          "operator",
          "stick",
          "rov 1",
          "held",
          "velocity",
          number % 2 == 0,
          "unauthorised",
          "nobody has the helm",
          number};
}

TEST(ActionKeeper, FilesEachRowWhileTheSessionGoesOn) {
  const TemporaryFolder folder;
  people::ActionKeeper keeper(folder / "store", "a run", begun, {});
  Store reader = Store::open(folder / "store", OpenMode::read_only);
  for (std::uint64_t i = 1; i <= 300; ++i) keeper.keep(action(i));
  EXPECT_TRUE(comes_true([&] { return reader.find_actions(keeper.id()).size() == 300; }));
  const auto rows = reader.find_actions(keeper.id());
  for (std::uint64_t i = 1; i <= 300; ++i) EXPECT_EQ(rows[i - 1], action(i));
  ASSERT_EQ(reader.list_sessions().size(), 1U);
  EXPECT_EQ(reader.list_sessions()[0], (store::SessionRow{keeper.id(), "a run", begun, 300}));
}

TEST(ActionKeeper, FilesWhatWaitsBeforeItGoesAndKeepsSessionsApart) {
  const TemporaryFolder folder;
  for (int session = 0; session < 2; ++session) {
    people::ActionKeeper keeper(folder / "store", "a run", begun, {});
    for (std::uint64_t i = 1; i <= 10; ++i) keeper.keep(action(i));
  }
  Store reader = Store::open(folder / "store", OpenMode::read_only);
  EXPECT_EQ(reader.find_actions(1).size(), 10U);
  EXPECT_EQ(reader.find_actions(2).size(), 10U);
  EXPECT_TRUE(contains(error_of([&] { return reader.find_actions(3); }), "session 3 is not in"));
}

TEST(ActionKeeper, NobodyChangesOrRemovesARow) {
  const TemporaryFolder folder;
  { people::ActionKeeper(folder / "store", "a run", begun, {}).keep(action(1)); }
  auto database =
      store::Database::open(folder / "store" / "catalogue.sqlite", store::Database::Access::write);
  for (const char* const sql :
       {"UPDATE session_action SET who = 'x'", "DELETE FROM session_action"})
    EXPECT_TRUE(contains(error_of([&] {
                           database.execute(sql);
                           return 0;
                         }),
                         "what was done in a session is never"));
}

// A store that takes no more is said once; the run goes on.
TEST(ActionKeeper, SaysOnceThatTheStoreTakesNoMore) {
  const TemporaryFolder folder;
  std::vector<std::string> said;
  {
    people::ActionKeeper keeper(folder / "store", "a run", begun,
                                [&](const std::string& text) { said.push_back(text); });
    for (int i = 0; i < 5; ++i) keeper.keep(action(1));  // a number twice
  }
  ASSERT_EQ(said.size(), 1U);
  EXPECT_TRUE(contains(said[0], "the log of the run"));
}

}  // namespace
}  // namespace slackwater::tests::action_keeper_test
