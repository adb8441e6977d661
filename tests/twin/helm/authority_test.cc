#include "twin/helm/authority.h"

#include <gtest/gtest.h>

#include <array>

#include "fields/base/check.h"
#include "fields/base/numbers/random.h"

namespace slackwater::twin::authority_test {
namespace {

constexpr std::string_view rov = "rov";

bool asks(Authority& authority, std::string_view client, double now_s) {
  return !authority.ask(client, 0, rov, now_s);
}

TEST(Authority, IsGotByAskingAndWhileNobodyHoldsItByAFirstCommand) {
  Authority authority(2);
  EXPECT_EQ(authority.holder(0), "");
  EXPECT_TRUE(asks(authority, "ann", 0));
  EXPECT_EQ(authority.holder(0), "ann");
  EXPECT_FALSE(authority.refusal("bob", 1, "usv", 0));
  authority.note_command("bob", 1, Keeping::waypoints, 0);
  EXPECT_EQ(authority.holder(1), "bob");
}

TEST(Authority, OthersAreRefusedByName) {
  Authority authority(1);
  ASSERT_TRUE(asks(authority, "ann", 0));
  for (const auto& answer :
       {authority.ask("bob", 0, rov, 1), authority.refusal("bob", 0, rov, 1),
        authority.release("bob", 0, rov, 1), authority.allow_take_over("bob", 0, rov, 1)}) {
    ASSERT_TRUE(answer);
    EXPECT_NE(answer->find("rov is held by ann"), std::string::npos) << *answer;
  }
  EXPECT_EQ(authority.holder(0), "ann");
  EXPECT_THROW(authority.note_command("bob", 0, Keeping::asked, 1), ContractViolation);
}

TEST(Authority, IsGivenBackByItsHolderAlone) {
  Authority authority(1);
  EXPECT_TRUE(authority.release("ann", 0, rov, 0)) << "nobody holds it";
  ASSERT_TRUE(asks(authority, "ann", 0));
  EXPECT_TRUE(authority.release("bob", 0, rov, 1));
  EXPECT_FALSE(authority.release("ann", 0, rov, 1));
  EXPECT_EQ(authority.holder(0), "");
}

TEST(Authority, OfVelocityAndThrustersEndsOneSecondAfterTheLastOfThem) {
  Authority authority(1);
  ASSERT_TRUE(asks(authority, "ann", 0));
  authority.note_command("ann", 0, Keeping::renewed, 5);
  authority.note_command("ann", 0, Keeping::renewed, 5.5);
  EXPECT_TRUE(authority.refusal("bob", 0, rov, 6.4));
  EXPECT_FALSE(authority.refusal("bob", 0, rov, 6.5));
  authority.look(6.4);
  EXPECT_EQ(authority.holder(0), "ann");
  authority.look(6.5);
  EXPECT_EQ(authority.holder(0), "");
}

TEST(Authority, OfAListLastsUntilThatIsDone) {
  Authority authority(1);
  authority.note_command("ann", 0, Keeping::waypoints, 0);
  authority.look(1e5);
  EXPECT_EQ(authority.holder(0), "ann");
  authority.end(0);
  EXPECT_EQ(authority.holder(0), "");
}

TEST(Authority, IsTakenOverByAskingWithLeaveAlone) {
  Authority authority(1);
  ASSERT_TRUE(asks(authority, "ann", 0));
  EXPECT_FALSE(authority.allow_take_over("ann", 0, rov, 1));
  // A command is no way round asking.
  EXPECT_TRUE(authority.refusal("bob", 0, rov, 2));
  EXPECT_TRUE(asks(authority, "bob", 2));
  EXPECT_EQ(authority.holder(0), "bob");
  EXPECT_FALSE(asks(authority, "eve", 3)) << "the leave went with the change of hands";
}

TEST(Authority, ALeaveLapsesAfterTenSeconds) {
  Authority authority(1);
  ASSERT_TRUE(asks(authority, "ann", 0));
  EXPECT_FALSE(authority.allow_take_over("ann", 0, rov, 1));
  EXPECT_FALSE(asks(authority, "bob", 11.01));
  EXPECT_FALSE(authority.allow_take_over("ann", 0, rov, 20));
  EXPECT_TRUE(asks(authority, "bob", 30));
}

TEST(Authority, OfAClientThatIsGoneIsNobodys) {
  Authority authority(3);
  for (const std::size_t vehicle : {0U, 2U})
    authority.note_command("ann", vehicle, Keeping::asked, 0);
  authority.note_command("bob", 1, Keeping::asked, 0);
  EXPECT_EQ(authority.lost("ann", 1), (std::vector<std::size_t>{0, 2}));
  EXPECT_TRUE(authority.lost("ann", 1).empty());
  EXPECT_TRUE(authority.lost("", 1).empty());
  EXPECT_EQ(authority.holder(1), "bob");
}

/// The rules once more, in the plainest way: what each client may do now.
struct Model {
  std::string holder;
  Keeping keeping = Keeping::asked;
  double renewed_s = 0;
  double leave_until_s = -1;

  void look(double now_s) {
    if (!holder.empty() && keeping == Keeping::renewed && now_s >= renewed_s + 1) *this = {};
  }
  [[nodiscard]] bool may_command(const std::string& client) const {
    return holder.empty() || holder == client;
  }
  [[nodiscard]] bool may_ask(const std::string& client, double now_s) const {
    return may_command(client) || now_s <= leave_until_s;
  }
};

TEST(Authority, NoSequenceOfDoingsMakesTwoHoldersOrTakesACommandOfAnother) {
  const std::array<std::string, 4> clients{"ann", "bob", "eve", "joe"};
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Rng rng(seed, "authority_test");
    SCOPED_TRACE(seed);
    Authority authority(1);
    Model model;
    double now_s = 0;
    for (int i = 0; i < 400; ++i) {
      now_s += 0.25 * static_cast<double>(rng.bits() % 5);
      model.look(now_s);
      const std::string& client = clients[rng.bits() % clients.size()];
      switch (rng.bits() % 7) {
        case 0:
          ASSERT_EQ(asks(authority, client, now_s), model.may_ask(client, now_s));
          if (model.may_ask(client, now_s)) model = {client, Keeping::asked, now_s, -1};
          break;
        case 1:
        case 2:
        case 3: {
          const auto keeping = static_cast<Keeping>(rng.bits() % 3);
          ASSERT_EQ(!authority.refusal(client, 0, rov, now_s), model.may_command(client));
          if (!model.may_command(client)) {
            ASSERT_THROW(authority.note_command(client, 0, keeping, now_s), ContractViolation);
            break;
          }
          authority.note_command(client, 0, keeping, now_s);
          model = {client, keeping, now_s, model.holder.empty() ? -1 : model.leave_until_s};
          break;
        }
        case 4:
          ASSERT_EQ(!authority.release(client, 0, rov, now_s), model.holder == client);
          if (model.holder == client) model = {};
          break;
        case 5:
          ASSERT_EQ(!authority.allow_take_over(client, 0, rov, now_s), model.holder == client);
          if (model.holder == client) model.leave_until_s = now_s + 10;
          break;
        default:
          ASSERT_EQ(!authority.lost(client, now_s).empty(), model.holder == client);
          if (model.holder == client) model = {};
      }
      authority.look(now_s);
      ASSERT_EQ(authority.holder(0), model.holder);
    }
  }
}

}  // namespace
}  // namespace slackwater::twin::authority_test
