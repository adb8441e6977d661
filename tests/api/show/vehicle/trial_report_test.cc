#include "api/show/vehicle/trial_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "fields/base/constants.h"

namespace slackwater::api::trial_report_test {
namespace {

using calibration::EndedOn;
using twin::TrialQuantity;

void expect_said(const std::string& text, const std::vector<const char*>& said) {
  for (const char* words : said)
    EXPECT_NE(text.find(words), std::string::npos) << words << "\n-> " << text;
  for (const char* bad : {"nan", "inf"}) EXPECT_EQ(text.find(bad), std::string::npos) << text;
}

struct Told {
  twin::Trial trial;
  twin::TrialRun run;
  twin::TrialErrors errors;
};
Told short_trial() {
  Told told;
  told.trial.name = "turn.csv";
  told.trial.time_s = {10, 11, 12};
  const double d = constants::degree;
  told.trial.measured = {{TrialQuantity::north, {0, 1, 2}},
                         {TrialQuantity::east, {0, 0, 0}},
                         {TrialQuantity::yaw, {0, 5 * d, 10 * d}}};
  told.run.rows = 3;
  told.run.ended_at_s = 12;
  told.run.ours = {{0, 1, 2.1}, {0, 0, 0}, {0, 4 * d, 8 * d}};
  told.errors = twin::errors_of(told.trial, told.run);
  return told;
}

TEST(TrialReport, TellsErrorsInWordsAndInJson) {
  const Told told = short_trial();
  expect_said(trial_text(told.trial, told.run, told.errors),
              {"Trial turn.csv: 2 s, 3 rows.", "yaw_deg         1.581       -1.5          2",
               "15.81 %", "0.1 m off after 2 m (5.00 %)"});
  const nlohmann::json json = trial_json(told.trial, told.run, told.errors);
  EXPECT_EQ(json["rows"], 3);
  EXPECT_TRUE(json["diverged_after_s"].is_null());
  EXPECT_EQ(json["errors"][2]["quantity"], "yaw_rad");
  EXPECT_EQ(json["errors"][2]["unit"], "rad");
  EXPECT_NEAR(json["errors"][2]["bias"].get<double>(), -1.5 * constants::degree, 1e-12);
  EXPECT_TRUE(json["errors"][1]["rms_of_range"].is_null());
  EXPECT_NEAR(json["end"]["off_of_way"].get<double>(), 0.05, 1e-12);
  EXPECT_EQ(json["end"]["after_s"], 2);
}

TEST(TrialReport, SaysWhereItDiverged) {
  Told told = short_trial();
  told.run.rows = 2;
  told.run.ended_at_s = 11.5;
  for (auto& ours : told.run.ours) ours.resize(2);
  told.errors = twin::errors_of(told.trial, told.run);
  expect_said(trial_text(told.trial, told.run, told.errors),
              {"diverged 1.5 s into the trial", "of the 2 rows before"});
  EXPECT_EQ(trial_json(told.trial, told.run, told.errors)["diverged_after_s"], 1.5);
}

TrialFit some_fit() {
  TrialFit fit;
  fit.fit.parameters = {
      {"damping.X_u", -77.5544, -775.544, -7.75544, -100.823456, 0.35, true, EndedOn::neither},
      {"damping.N_r", -42, -420, -4.2, -4.2, 0.2, true, EndedOn::high},
      {"hotel_w", 20, 2, 200, 20, {}, false, EndedOn::neither},
      {"mounts[0].position_m[1]", -0.4, -4, -0.04, -0.35, 0.01, true, EndedOn::neither}};
  fit.fit.correlation = Eigen::MatrixXd::Identity(4, 4);
  fit.fit.correlation(0, 3) = fit.fit.correlation(3, 0) = -0.95;
  fit.fit.rms_before = 0.2;
  fit.fit.rms_after = 0.02;
  fit.fit.residuals = 600;
  fit.fit.effective_residuals = 43.2;
  fit.fit.has_converged = true;
  fit.fit.ended = "converged after 7 steps: the misfit no longer falls";
  fit.before = short_trial().errors;
  fit.after = fit.before;
  fit.left_out = {TrialQuantity::east};
  fit.every_row = 3;
  return fit;
}

TEST(TrialReport, TellsAFitWithItsUncertaintyAndNeverSilently) {
  const TrialFit fit = some_fit();
  expect_said(fit_text(fit),
              {"600 residuals are worth 43 independent ones", "-77.5544     -100.823         0.35",
               "determined", "ended on its upper bound, -4.2", "not determined by this trial",
               "damping.X_u and mounts[0].position_m[1] make up for each other (correlation -0.95)",
               "east_m never changes", "one row of 3", "The file stays as it is", "yaw_deg"});
  EXPECT_EQ(fitted_yaml(fit),
            "damping: {X_u: -100.823}\n"
            "# damping.N_r: -4.2 ended on a bound of the fit: look for what is wrong first\n"
            "# mounts[0].position_m[1]: -0.35\n");
  const nlohmann::json json = fit_json(fit);
  EXPECT_EQ(json["keys"][0]["value"], -100.823456);
  EXPECT_EQ(json["keys"][1]["ended_on"], "high");
  EXPECT_TRUE(json["keys"][2]["standard_deviation"].is_null());
  EXPECT_EQ(json["correlation"][0][3], -0.95);
  EXPECT_EQ(json["left_out"][0], "east_m");
  EXPECT_EQ(json["yaml"], fitted_yaml(fit));
}

TEST(TrialReport, AFitThatDeterminesNothingSaysSo) {
  TrialFit fit = some_fit();
  fit.fit.parameters.erase(fit.fit.parameters.begin(), fit.fit.parameters.begin() + 2);
  fit.fit.parameters.pop_back();
  fit.fit.correlation = Eigen::MatrixXd::Identity(1, 1);
  EXPECT_EQ(fitted_yaml(fit), "");
  expect_said(fit_text(fit), {"The trial determines none of them"});
}

}  // namespace
}  // namespace slackwater::api::trial_report_test
