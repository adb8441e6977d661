// CSV files as trials: what columns are by their names, and what is refused, with FILE:LINE.
#include "api/ask/vehicle/read_trial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "tests/support/error_of.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/vehicle_for_tests.h"
#include "twin/body/actuator_values.h"
#include "twin/handling/trial_error.h"

namespace slackwater::api::read_trial_test {
namespace {

using twin::Trial;
using twin::TrialQuantity;

const twin::Vehicle& remus() {
  static const twin::Vehicle vehicle = tests::bundled_vehicle("remus100");
  return vehicle;
}
Trial remus_trial(const std::string& text, const TrialOptions& options = {}) {
  return trial_of(text, "dive.csv", remus(), options);
}

TEST(ReadTrial, ColumnsAreWhatTheirNamesSay) {
  const Trial trial = remus_trial(
      "# from the log of 3 May\r\n"
      "time_s,propeller_rpm,\"rudder_deg\",elevator_share,yaw_deg,r_deg_s,depth_m,speed_m_s\r\n"
      "\r\n"
      "100,600,5,0,350,,10,1\r\n"
      "100.5,,-5,-0.5,NaN,2,10.5,+1.25\r\n"
      "102,0,,1,10,-,na,1e0\r\n");
  const double degree = constants::degree;
  EXPECT_EQ(trial.name, "dive.csv");
  EXPECT_EQ(trial.time_s, (std::vector<double>{100, 100.5, 102}));
  ASSERT_EQ(trial.commands.size(), 3U);
  EXPECT_EQ(trial.commands[0].channel, 0U);
  EXPECT_NEAR(trial.commands[0].value[0], 20 * constants::pi, 1e-12);
  EXPECT_EQ(trial.commands[0].value[1], trial.commands[0].value[0]) << "held from the row before";
  EXPECT_EQ(trial.commands[0].value[2], 0);
  EXPECT_EQ(trial.commands[1].channel, twin::rudder_channel);
  EXPECT_EQ(trial.commands[1].value, (std::vector<double>{5 * degree, -5 * degree, -5 * degree}));
  EXPECT_TRUE(trial.commands[2].is_share);
  EXPECT_EQ(trial.commands[2].value, (std::vector<double>{0, -0.5, 1}));
  const auto& yaw = twin::measured(trial, TrialQuantity::yaw)->value;
  EXPECT_EQ(yaw[0], 350 * degree);
  EXPECT_TRUE(std::isnan(yaw[1]));
  EXPECT_NEAR(twin::range_of(*twin::measured(trial, TrialQuantity::yaw)), 20 * degree, 1e-12);
  EXPECT_EQ(twin::measured(trial, TrialQuantity::r)->value[1], 2 * degree);
  EXPECT_EQ(twin::measured(trial, TrialQuantity::down)->value[1], 10.5);
  EXPECT_EQ(twin::measured(trial, TrialQuantity::speed)->value[1], 1.25);
}

TEST(ReadTrial, ColumnsMayBeRenamedAndLeftOut) {
  TrialOptions options;
  options.columns = {parse_trial_column("stern_plane_rad=elevator_rad"),
                     parse_trial_column("battery_v=none")};
  options.current_m_s = {0.1, 0.2, 0};
  options.first_depth_m = 10;
  const Trial trial =
      remus_trial("t_s,stern_plane_rad,battery_v,u_m_s\n0,0.1,x,0\n1,0,y,1\n", options);
  EXPECT_EQ(trial.commands[0].channel, twin::elevator_channel);
  EXPECT_EQ(trial.commands[0].value[0], 0.1);
  EXPECT_EQ(trial.measured.size(), 1U);
  EXPECT_EQ(trial.current_m_s, (twin::Triple<double>{0.1, 0.2, 0}));
  EXPECT_EQ(trial.first_depth_m, 10);
}

TEST(ReadTrial, RefusalsSayWhereWhatAndWhatToDo) {
  struct Case {
    const char* text;
    std::vector<const char*> said;
  };
  const std::vector<Case> cases{
      {"", {"dive.csv:1: ", "the file is empty"}},
      {"propeller_rpm,u_m_s\n0,0\n", {"dive.csv:1: found no column of times", "t_s or time_s"}},
      {"t_s,u_m_s\n0,0\n1,0\n",
       {"dive.csv:1: found no column of commands of the REMUS 100", "propeller_rad_s",
        "rudder_deg"}},
      {"t_s,propeller_rpm\n0,0\n1,0\n", {"dive.csv:1: found nothing that was measured", "yaw_rad"}},
      {"t_s,propeler_rpm,u_m_s\n",
       {"dive.csv:1: column 'propeler_rpm': we do not know it", "did you mean 'propeller_rpm'",
        "--column propeler_rpm=NAME", "=none"}},
      {"t_s,propeller_n,u_m_s\n", {"column 'propeller_n'", "propeller_rad_s, propeller_rpm"}},
      {"t_s,propeller_rpm,u_m_s,roll_rad,roll_deg\n",
       {"column 'roll_deg': found a second column of roll_rad"}},
      {"t_s,rudder_rad,rudder_deg,u_m_s\n", {"'rudder_deg': found a second column of rudder"}},
      {"t_s,time_s,rudder_deg,u_m_s\n", {"'time_s': found a second column of times"}},
      {"t_s;rudder_deg;u_m_s\n", {"dive.csv:1: ", "semicolons and tabs are not read"}},
      {"t_s,rudder_deg,u_m_s\n0,0,0\n\n1,0,fast\n",
       {"dive.csv:4: u_m_s: found 'fast', expected a number"}},
      {"t_s,rudder_deg,u_m_s\n0,0,0\n1,0,\"1,5\"\n", {"dive.csv:3: ", "as 1.5"}},
      {"t_s,rudder_deg,u_m_s\n0,0,0\n1,0,1e300\n", {"dive.csv:3: u_m_s", "at most 1e+08"}},
      {"t_s,rudder_deg,u_m_s\n0,0,0\n1,0,inf\n", {"dive.csv:3: u_m_s"}},
      {"t_s,rudder_deg,u_m_s\n0,0,0\n1,0,0\n1,0,0\n",
       {"dive.csv:4: t_s: found 1 after 1, expected times that rise"}},
      {"t_s,rudder_deg,u_m_s\n0,0,0\n,0,0\n", {"dive.csv:3: t_s: found a row without its time"}},
      {"t_s,rudder_deg,u_m_s\n0,,0\n1,0,0\n",
       {"dive.csv:2: rudder_deg: found no value in the first row"}},
      {"t_s,rudder_deg,u_m_s\n0,40,0\n1,0,0\n",
       {"dive.csv:2: rudder_deg: found 40, expected -13.5791 to 13.5791", "check the unit"}},
      {"t_s,rudder_share,u_m_s\n0,1.2,0\n1,0,0\n", {"found 1.2, expected -1 to 1"}},
      {"t_s,rudder_deg,u_m_s\n0,0\n", {"dive.csv:2: found 2 cells, expected 3"}},
      {"t_s,rudder_deg,u_m_s\n0,0,\"0\n", {"dive.csv:2: found a quote that is not closed"}},
      {"t_s,rudder_deg,u_m_s\n0,0,0\n", {"dive.csv:2: found 1 row, expected two at least"}},
      {"t_s,rudder_deg,u_m_s\n0,0,1\n1,0,\n",
       {"dive.csv:3: found no measured value below the first row"}},
      {"t_s,rudder_deg,u_m_s\n0,0,0\n1e6,0,0\n",
       {"dive.csv:3: found a trial of 278 h, expected at most 13.9 h"}},
      {"t_s,\x1b[2Jrudder_deg,u_m_s\n", {"column '?[2Jrudder_deg'"}}};
  for (const Case& one : cases) {
    const std::string said = tests::error_of([&] { return remus_trial(one.text); });
    for (const char* words : one.said)
      EXPECT_NE(said.find(words), std::string::npos) << one.text << "\n-> " << said;
    EXPECT_EQ(said.find('\x1b'), std::string::npos);
  }
  const std::string with_nul = std::string("t_s,rudder_deg,u_m_s\n0,") + '\0' + ",0\n";
  const std::string nul = tests::error_of([&] { return remus_trial(with_nul); });
  EXPECT_NE(nul.find("bytes that are no text"), std::string::npos) << nul;
  TrialOptions options;
  options.columns = {{"helm", "rudder_deg"}};
  EXPECT_NE(tests::error_of([&] {
              return remus_trial("t_s,rudder_deg\n", options);
            }).find("found no column 'helm', which is to be 'rudder_deg'; it has 't_s'"),
            std::string::npos);
}

TEST(ReadTrial, TooManyRowsAreRefused) {
  std::string text = "t_s,rudder_deg,u_m_s\n";
  for (std::size_t i = 0; i <= most_trial_rows; ++i)
    text += std::to_string(static_cast<double>(i) * 1e-3) + ",0,0\n";
  const std::string said = tests::error_of([&] { return remus_trial(text); });
  EXPECT_NE(said.find("dive.csv:1000002: found more than 1000000 rows"), std::string::npos) << said;
}

TEST(ReadTrial, NamesOfColumnsHaveTwoSides) {
  for (const char* text : {"rudder_deg", "=rudder_deg", "helm=", "a=b=c", ""})
    EXPECT_NE(
        tests::error_of([&] { return parse_trial_column(text).name; }).find("--column: found"),
        std::string::npos)
        << text;
}

TEST(ReadTrial, FilesOnlyAndThoseThatAreThere) {
  const tests::TemporaryFolder folder;
  EXPECT_NE(
      tests::error_of([&] { return read_trial(folder / "no.csv", remus()); }).find("cannot read"),
      std::string::npos);
  EXPECT_NE(tests::error_of([&] { return read_trial(folder.path(), remus()); }).find("the folder"),
            std::string::npos);
  std::ofstream(folder / "yes.csv") << "t_s,rudder_deg,u_m_s\n0,0,0\n1,0,0\n";
  EXPECT_EQ(read_trial(folder / "yes.csv", remus()).rows(), 2U);
}

TEST(ReadTrial, FossensFilesAreTrials) {
  SLACKWATER_NEEDS_SHARED(shared);
  const twin::Vehicle otter = tests::bundled_vehicle("otter");
  const Trial turn = read_trial(shared / "data/fossen/otter_turn_100_80.csv", otter);
  EXPECT_EQ(turn.rows(), 601U);
  EXPECT_EQ(turn.commands.size(), 2U);
  EXPECT_EQ(turn.measured.size(), 12U);
  // The shafts are behind their lag of 0.1 s in the file, and ours lags them once more.
  const twin::TrialErrors errors = twin::errors_of(turn, twin::replayed(otter, turn));
  for (const twin::TrialError& error : errors.error)
    if (error.quantity == TrialQuantity::u || error.quantity == TrialQuantity::r)
      EXPECT_LT(error.share.value(), 0.05) << twin::name_of(error.quantity);
  TrialOptions options;
  options.columns = {{"stern_plane_rad", "elevator_rad"}};
  EXPECT_EQ(read_trial(shared / "data/fossen/remus100_rudder10_1200rpm.csv", remus(), options)
                .commands.size(),
            3U);
}

}  // namespace
}  // namespace slackwater::api::read_trial_test
