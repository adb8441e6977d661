// Who is in a session, and by which token.
#include "api/door/people/seats.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "tests/support/contains.h"
#include "tests/support/error_of.h"
#include "tests/support/keep_secret.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::seats_test {
namespace {

using people::NoSeat;
using people::Role;
using people::Seats;
using people::TokenBook;

const UtcTime now = parse_utc("2026-05-01T06:00:00Z");
const std::string ann = "ann-0123456789abcdef", crowd = "crowd-0123456789abcdef";

TokenBook book(const std::string& yaml) {
  const TemporaryFolder folder;
  std::ofstream(folder / "people.yaml") << yaml;
  keep_secret(folder / "people.yaml");
  return TokenBook::read(folder / "people.yaml");
}

Seats seats() {
  return Seats(
      book("people:\n"
           "  - {name: Ann, role: operator, token: " +
           ann +
           ", until: 2026-05-01T18:00:00Z}\n"
           "  - {role: spectator, token: " +
           crowd + ", until: 2026-05-02T00:00:00Z, seats: 2}\n"));
}

Seats::Taken taken(Seats& seats, const std::string& token, const std::string& name = "Bo",
                   UtcTime at = now) {
  auto outcome = seats.take(token, name, at);
  const auto* refused = std::get_if<NoSeat>(&outcome);
  EXPECT_EQ(refused, nullptr) << (refused == nullptr ? "" : refused->text);
  return refused == nullptr ? std::get<Seats::Taken>(outcome) : Seats::Taken{};
}

int status(const Seats& seats, const std::string& token, UtcTime at = now) {
  const auto refused = seats.refusal(token, at);
  return refused ? refused->status : 200;
}

TEST(Seats, AreTakenByTokensWithTheirRoleAndName) {
  Seats all = seats();
  const auto first = taken(all, ann);
  EXPECT_EQ(all.find(first.seat)->name, "Ann") << "the token's, whatever is said";
  EXPECT_EQ(all.find(first.seat)->role, Role::drives);
  EXPECT_EQ(status(all, ann), 409) << "one seat, and it is taken";
  const auto second = taken(all, crowd,
                            "Z\xC3\xB6"
                            "e\n");
  EXPECT_EQ(all.find(second.seat)->name,
            "Z\xC3\xB6"
            "e");
  const auto third = taken(all, crowd, "");
  EXPECT_EQ(all.find(third.seat)->name, "spectator 3");
  EXPECT_EQ(status(all, crowd), 409);
  all.leave(third.seat);
  EXPECT_EQ(status(all, crowd), 200);
  EXPECT_NE(taken(all, crowd).seat, third.seat) << "no number is used twice";
}

TEST(Seats, AreNotOpenedByWrongEmptyOrEndedTokens) {
  Seats all = seats();
  for (const std::string wrong : {"", "x", "ann-0123456789abcdeF", "ann-0123456789abcdef0"})
    EXPECT_EQ(status(all, wrong), 401) << wrong;
  EXPECT_EQ(status(all, ann, parse_utc("2026-05-01T17:59:59Z")), 200);
  EXPECT_EQ(status(all, ann, parse_utc("2026-05-01T18:00:00Z")), 401);
  const auto refused = all.refusal(ann, parse_utc("2026-05-02T00:00:00Z"));
  EXPECT_EQ(refused->text.find("found a token that ended at 2026-05-01T18:00:00"), 0U)
      << refused->text;
}

TEST(Seats, AreKeptForWhoIsCutOffAndTakenUpOnceWithEachResumeToken) {
  Seats all = seats();
  const auto first = taken(all, ann);
  all.cut_off(first.seat, 1'000);
  EXPECT_FALSE(all.find(first.seat)->is_here);
  EXPECT_EQ(status(all, ann), 409) << "the seat is kept";
  EXPECT_TRUE(all.over(30'999, now).empty());
  const auto back = taken(all, first.resume);
  EXPECT_TRUE(back.is_back);
  EXPECT_EQ(back.seat, first.seat);
  EXPECT_TRUE(all.find(first.seat)->is_here);
  EXPECT_TRUE(all.over(1'000'000, now).empty());
  // Its answer may never have arrived; once it has, an old token is somebody's who listened.
  EXPECT_NE(back.resume, first.resume);
  const auto once_more = taken(all, first.resume);
  EXPECT_EQ(once_more.seat, first.seat);
  EXPECT_EQ(status(all, back.resume), 401) << "that one never arrived";
  all.confirm(first.seat);
  const auto replayed = all.refusal(first.resume, now);
  ASSERT_TRUE(replayed);
  EXPECT_EQ(replayed->status, 401);
  EXPECT_NE(replayed->text.find("used before"), std::string::npos);
  all.cut_off(first.seat, 2'000);
  EXPECT_EQ(all.over(32'000, now), std::vector<unsigned>{first.seat});
  all.leave(first.seat);
  EXPECT_EQ(status(all, once_more.resume), 401);
  EXPECT_EQ(status(all, ann), 200);
}

TEST(Seats, EndWithTheirToken) {
  Seats all = seats();
  const auto first = taken(all, ann);
  EXPECT_TRUE(all.over(0, parse_utc("2026-05-01T17:59:59Z")).empty());
  EXPECT_EQ(all.over(0, parse_utc("2026-05-01T18:00:00Z")), std::vector<unsigned>{first.seat});
  EXPECT_EQ(status(all, first.resume, parse_utc("2026-05-01T18:00:00Z")), 401);
}

TEST(TokenBook, RefusesWhatWouldLetAnybodyIn) {
  const auto refused = [](const std::string& line, const std::string& what) {
    const std::string text = error_of([&] { return book("people:\n  - {" + line + "}\n"); });
    EXPECT_TRUE(contains(text, "people.yaml:2"));
    EXPECT_TRUE(contains(text, what));
  };
  const std::string until = ", until: 2026-05-01T18:00:00Z";
  refused("role: operator, token: short" + until, "found 5 letters, expected 16");
  refused("role: operator, token: 'with space 0123456789'" + until, "expected 16 or more of a-z");
  refused("role: captain, token: " + ann + until, "found 'captain', expected spectator");
  refused("role: operator, token: " + ann + ", until: soon", "until");
  refused("name: Ann, role: operator, token: " + ann + until + ", seats: 2", "one name");
  refused("role: operator, token: " + ann + until + ", seat: 2", "seat");
  EXPECT_TRUE(contains(error_of([] { return book("people: []\n"); }), "found nobody"));
  EXPECT_TRUE(contains(error_of([&] {
                         return book("people:\n  - {role: operator, token: " + ann + until +
                                     "}\n  - {role: spectator, token: " + ann + until + "}\n");
                       }),
                       "stands twice"));
}

TEST(TokenBook, DrawsTokensThatNobodyGuesses) {
  const TokenBook one = TokenBook::drawn(now), other = TokenBook::drawn(now);
  std::set<std::string> all;
  for (const TokenBook* drawn : {&one, &other})
    for (const auto& grant : drawn->grants()) {
      EXPECT_EQ(grant.token.size(), 32U);
      all.insert(grant.token);
    }
  EXPECT_EQ(all.size(), 6U);
  EXPECT_EQ(one.find(one.grants()[1].token), std::size_t{1});
}

}  // namespace
}  // namespace slackwater::tests::seats_test
