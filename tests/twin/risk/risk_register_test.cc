#include "twin/risk/risk_register.h"

#include <algorithm>

#include "fields/base/config.h"
#include "fields/base/error.h"
#include "tests/support/shared_data.h"

namespace slackwater::tests::risk_register_test {
namespace {

using twin::Likelihood;
using twin::RiskCause;
using twin::RiskCauses;
using twin::RiskEntry;
using twin::RiskLevel;

std::vector<RiskCauses> flights(std::size_t all, RiskCause cause, std::size_t befell) {
  std::vector<RiskCauses> out(all);
  for (std::size_t i = 0; i < befell; ++i) out[i].add(cause);
  return out;
}

const RiskEntry& of(const std::vector<RiskEntry>& risks, RiskCause cause) {
  return *std::find_if(risks.begin(), risks.end(),
                       [&](const RiskEntry& risk) { return risk.cause == cause; });
}

std::vector<twin::Consequence> read(const std::string& yaml) {
  return twin::read_consequences(Config::parse(yaml, "task.yaml"));
}

TEST(RiskRegister, CountsEachCauseOnceAFlightWithTheIntervalOfSequentialStopping) {
  const auto risks = twin::risk_register(flights(24, RiskCause::tether, 6), {});
  ASSERT_EQ(risks.size(), twin::risk_cause_count);
  const RiskEntry& tether = of(risks, RiskCause::tether);
  EXPECT_EQ(tether.befell, 6U);
  EXPECT_EQ(tether.flights, 24U);
  EXPECT_EQ(tether.share(), 0.25);
  const twin::SuccessInterval bounds = twin::success_interval(6, 24, 0.95);
  EXPECT_EQ(tether.probability.low, bounds.low);
  EXPECT_EQ(tether.probability.high, bounds.high);
  EXPECT_EQ(of(risks, RiskCause::energy).befell, 0U);
}

TEST(RiskRegister, HasClassesWhoseEdgesBelongToTheHigherOne) {
  EXPECT_EQ(twin::likelihood_of(0), Likelihood::rare);
  EXPECT_EQ(twin::likelihood_of(0.0099), Likelihood::rare);
  EXPECT_EQ(twin::likelihood_of(0.01), Likelihood::unlikely);
  EXPECT_EQ(twin::likelihood_of(0.05), Likelihood::possible);
  EXPECT_EQ(twin::likelihood_of(0.2), Likelihood::likely);
  EXPECT_EQ(twin::likelihood_of(0.5), Likelihood::expected);
  EXPECT_EQ(twin::likelihood_of(1), Likelihood::expected);
  // 1 x 5, 2 x 3, 3 x 4, 3 x 5.
  EXPECT_EQ(twin::level_of(Likelihood::rare, 5), RiskLevel::low);
  EXPECT_EQ(twin::level_of(Likelihood::unlikely, 3), RiskLevel::medium);
  EXPECT_EQ(twin::level_of(Likelihood::possible, 4), RiskLevel::medium);
  EXPECT_EQ(twin::level_of(Likelihood::possible, 5), RiskLevel::high);
}

TEST(RiskRegister, NeverFallsAsMoreBefallsOrAsItWouldBeWorse) {
  RiskLevel before = RiskLevel::low;
  for (int grade = 1; grade <= 5; ++grade) {
    RiskLevel last = RiskLevel::low;
    for (int percent = 0; percent <= 100; ++percent) {
      const RiskLevel level = twin::level_of(twin::likelihood_of(percent / 100.0), grade);
      EXPECT_GE(level, last) << percent << " % of grade " << grade;
      last = level;
    }
    EXPECT_GE(last, before);
    before = last;
  }
}

TEST(RiskRegister, PutsTheGravestFirstAndTakesTheWorseOfTwoTasks) {
  std::vector<RiskCauses> befell = flights(50, RiskCause::work, 40);
  for (std::size_t i = 0; i < 10; ++i) befell[i].add(RiskCause::collision);
  auto harms = read(
      "risks:\n"
      "  - {cause: work, people: 1, environment: 1, asset: 1, schedule: 2, cost: 1}\n"
      "  - {cause: collision, people: 2, environment: 1, asset: 3, schedule: 1, cost: 1}\n");
  for (const auto& other : read("risks: [{cause: collision, people: 5, environment: 1, asset: 1, "
                                "schedule: 1, cost: 1}]"))
    harms.push_back(other);
  const auto risks = twin::risk_register(befell, harms);
  EXPECT_EQ(risks.front().cause, RiskCause::collision);
  EXPECT_EQ(risks.front().at_worst, RiskLevel::high);  // 20 %, likely, and people 5
  EXPECT_EQ(risks.front().consequence->worst(), twin::Harmed::people);
  EXPECT_EQ(risks.front().consequence->grade[2], 3);
  EXPECT_EQ(risks[1].cause, RiskCause::work);
  EXPECT_EQ(risks[1].at_least, RiskLevel::medium);
}

TEST(RiskRegister, OfFewFlightsSaysWhatItCouldBeAtWorst) {
  const auto few = twin::risk_register(flights(3, RiskCause::tether, 0),
                                       read("risks: [{cause: tether, people: 1, environment: 2, "
                                            "asset: 4, schedule: 4, cost: 4}]"));
  EXPECT_EQ(of(few, RiskCause::tether).at_least, RiskLevel::low);
  EXPECT_EQ(of(few, RiskCause::tether).at_worst, RiskLevel::high);
  EXPECT_EQ(few.front().cause, RiskCause::tether);
}

/// A flight that nothing befell does not make a cause rare.
TEST(RiskRegister, NamesNoClassThatTheFlightsDoNotShow) {
  const auto unseen = [](std::size_t all) {
    return of(twin::risk_register(flights(all, RiskCause::work, 0), {}), RiskCause::tether);
  };
  EXPECT_EQ(twin::likelihood_text(unseen(1)), "rare to expected");
  EXPECT_EQ(twin::level_text(unseen(1)), "low to high");
  EXPECT_EQ(twin::likelihood_text(unseen(24)), "rare to likely") << "23 % at most";
  EXPECT_EQ(twin::likelihood_text(unseen(2000)), "rare (below 1 %)");
  EXPECT_EQ(twin::level_text(unseen(2000)), "low");
  const auto often = twin::risk_register(flights(2000, RiskCause::tether, 1500), {});
  EXPECT_EQ(twin::likelihood_text(of(often, RiskCause::tether)), "expected (50 % and more)");
}

TEST(Consequences, OfEachTaskThatComesWithTheProgramCoverItsCauses) {
  for (const auto& entry :
       std::filesystem::directory_iterator(source_folder() / "data" / "tasks")) {
    const auto harms = twin::read_consequences(Config::load(entry.path()));
    EXPECT_GE(harms.size(), 5U) << entry.path();
    for (const twin::Consequence& harm : harms) EXPECT_EQ(harm.status, "estimate");
  }
}

TEST(Consequences, RefuseWhatIsNoneInOneSentence) {
  const auto message = [](const std::string& entry) {
    try {
      (void)read("risks: [" + entry + "]");
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  const std::string grades = "people: 1, environment: 1, asset: 1, schedule: 1, cost: 1";
  EXPECT_EQ(message("{cause: work, " + grades + "}"), "no error");
  EXPECT_NE(message("{cause: sharks, " + grades + "}").find("found sharks, expected one of limit"),
            std::string::npos);
  EXPECT_NE(message("{cause: work, people: 6, environment: 1, asset: 1, schedule: 1, cost: 1}")
                .find("people"),
            std::string::npos);
  EXPECT_NE(message("{cause: work, people: 1, asset: 1, schedule: 1, cost: 1}").find("environment"),
            std::string::npos);
  EXPECT_NE(message("{cause: work, " + grades + "}, {cause: work, " + grades + "}").find("twice"),
            std::string::npos);
  EXPECT_NE(message("{cause: work, fame: 2, " + grades + "}").find("fame"), std::string::npos);
}

}  // namespace
}  // namespace slackwater::tests::risk_register_test
