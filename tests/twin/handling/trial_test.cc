// Trials flown again: by the vehicle that made them, by one that is a little different, and the
// runs of Fossen's models as trials, with the tolerances of tests/twin/held_against.
#include <gtest/gtest.h>

#include <cstdio>

#include "fields/base/constants.h"
#include "tests/support/error_of.h"
#include "tests/support/vehicle_for_tests.h"
#include "tests/twin/handling/trial_for_tests.h"
#include "tests/twin/held_against/reference_run.h"
#include "tests/twin/vehicle/changed_vehicle.h"
#include "twin/body/actuator_values.h"
#include "twin/handling/trial_error.h"

namespace slackwater::twin::trial_test {
namespace {

using tests::bundled_vehicle;
using tests::changed_vehicle;
using tests::commanded;
using tests::made_by;
using tests::reference_run;
using tests::RunRows;

constexpr TrialQuantity all[] = {TrialQuantity::north, TrialQuantity::east,  TrialQuantity::down,
                                 TrialQuantity::roll,  TrialQuantity::pitch, TrialQuantity::yaw,
                                 TrialQuantity::u,     TrialQuantity::v,     TrialQuantity::w,
                                 TrialQuantity::p,     TrialQuantity::q,     TrialQuantity::r,
                                 TrialQuantity::speed};

/// An Otter that turns, straightens and turns the other way.
Trial turns_of_an_otter() {
  return commanded({{0, [](double t_s) { return std::fmod(t_s, 20) < 10 ? 80.0 : 60.0; }},
                    {1, [](double t_s) { return std::fmod(t_s, 20) < 10 ? 60.0 : 80.0; }}},
                   60);
}

const TrialError& of(const TrialErrors& errors, TrialQuantity quantity) {
  for (const TrialError& error : errors.error)
    if (error.quantity == quantity) return error;
  throw std::logic_error("not measured");
}

TEST(Trial, TheVehicleThatMadeItHasNoError) {
  const Vehicle otter = bundled_vehicle("otter");
  Trial trial = turns_of_an_otter();
  trial.current_m_s = {0.1, -0.2, 0};
  trial = made_by(otter, trial, {std::begin(all), std::end(all)});
  const TrialRun run = replayed(otter, trial);
  EXPECT_FALSE(run.diverged(trial));
  EXPECT_EQ(run.rows, trial.rows());
  EXPECT_EQ(run.ended_at_s, trial.time_s.back());
  const TrialErrors errors = errors_of(trial, run);
  ASSERT_EQ(errors.error.size(), std::size(all));
  for (const TrialError& error : errors.error) {
    EXPECT_EQ(error.rms, 0) << name_of(error.quantity);
    EXPECT_EQ(error.largest, 0) << name_of(error.quantity);
    EXPECT_EQ(error.n, trial.rows() - 1);
    EXPECT_GT(error.range, 0) << name_of(error.quantity);
  }
  ASSERT_TRUE(errors.place);
  EXPECT_EQ(errors.place->off_m, 0);
  EXPECT_GT(errors.place->way_m, 30);
}

/// A state in the middle of a trial begins a trial: what the first row has is where ours begins.
TEST(Trial, GoesOnFromTheMotionOfItsFirstRow) {
  const Vehicle remus = bundled_vehicle("remus100");
  Trial trial = commanded({{0, [](double) { return 120.0; }},
                           {rudder_channel, [](double t_s) { return t_s < 20 ? 0.0 : 0.1; }}},
                          40);
  trial.first_depth_m = 20;
  trial = made_by(remus, trial, {std::begin(all), std::end(all)});
  const std::size_t begins = 150;  // 30 s
  Trial rest = trial;
  rest.first_depth_m.reset();
  const auto cut = [&](std::vector<double>& values) {
    values.erase(values.begin(), values.begin() + begins);
  };
  cut(rest.time_s);
  for (TrialCommand& command : rest.commands) cut(command.value);
  for (TrialColumn& column : rest.measured) cut(column.value);
  for (const TrialError& error : errors_of(rest, replayed(remus, rest)).error)
    // The fins' and the shaft's lag are through; times are of other roundings.
    EXPECT_LT(error.rms, 1e-6 * std::max(1.0, error.range)) << name_of(error.quantity);
}

TEST(Trial, MoreDragThanTheTrialsIsSlowerAndTurnsLess) {
  const Trial trial = made_by(bundled_vehicle("otter"), turns_of_an_otter(),
                              {TrialQuantity::north, TrialQuantity::east, TrialQuantity::yaw,
                               TrialQuantity::u, TrialQuantity::speed, TrialQuantity::r});
  const TrialErrors dragged = errors_of(
      trial, replayed(changed_vehicle("otter", {{"X_u: -77.5544", "X_u: -93.0"}}), trial));
  EXPECT_LT(of(dragged, TrialQuantity::u).bias, -0.05);
  EXPECT_LT(of(dragged, TrialQuantity::speed).bias, -0.05);
  EXPECT_GT(of(dragged, TrialQuantity::u).rms, -of(dragged, TrialQuantity::u).bias);
  EXPECT_GE(of(dragged, TrialQuantity::u).largest, of(dragged, TrialQuantity::u).rms);
  EXPECT_GT(dragged.place->share.value(), 0.05);
  const TrialErrors slippery = errors_of(
      trial, replayed(changed_vehicle("otter", {{"X_u: -77.5544", "X_u: -62.0"}}), trial));
  EXPECT_GT(of(slippery, TrialQuantity::u).bias, 0.05);
}

TEST(Trial, AnglesAreComparedTheShortWayAndTheirRangeIsUnwound) {
  Trial trial;
  trial.time_s = {0, 1, 2, 3};
  const double d = constants::degree, nan = constants::nan;
  trial.measured = {{TrialQuantity::yaw, {170 * d, 178 * d, -178 * d, -170 * d}},
                    {TrialQuantity::u, {1, nan, 1.5, nan}}};
  TrialRun run;
  run.rows = 4;
  run.ours = {{170 * d, -179 * d, -177 * d, 179 * d}, {1, 1, 1, 1}};
  const TrialErrors errors = errors_of(trial, run);
  const TrialError& yaw = errors.error[0];
  EXPECT_NEAR(yaw.range, 20 * d, 1e-12);
  EXPECT_NEAR(yaw.largest, 11 * d, 1e-12);
  EXPECT_NEAR(yaw.bias, (3 + 1 - 11) / 3.0 * d, 1e-12);
  EXPECT_NEAR(yaw.rms, std::sqrt((9 + 1 + 121) / 3.0) * d, 1e-12);
  EXPECT_NEAR(yaw.share.value(), yaw.rms / (20 * d), 1e-12);
  const TrialError& u = errors.error[1];
  EXPECT_EQ(u.n, 1U);
  EXPECT_EQ(u.bias, -0.5);
  EXPECT_FALSE(errors.place);
}

TEST(Trial, SharesAreOfTheRangeOfTheirChannel) {
  const Vehicle otter = bundled_vehicle("otter");
  Trial units = commanded(
      {{0, [](double) { return 0.5 * 103.93; }}, {1, [](double) { return -0.5 * 101.74; }}}, 10);
  const std::vector<TrialQuantity> turning{TrialQuantity::r, TrialQuantity::u};
  units = made_by(otter, units, turning);
  Trial shares = units;
  shares.commands[0] = {0, true, std::vector<double>(shares.rows(), 0.5)};
  shares.commands[1] = {1, true, std::vector<double>(shares.rows(), -0.5)};
  for (const TrialError& error : errors_of(shares, replayed(otter, shares)).error)
    EXPECT_LT(error.largest, 1e-12);
}

TEST(Trial, WhatDivergesEndsAtANamedTimeWithoutANumberThatIsNone) {
  // Drag in yaw ten thousand times too large: too stiff for its step.
  const Vehicle wild = changed_vehicle("remus100", {{"N_r_abs_r: -94", "N_r_abs_r: -940000"}});
  Trial trial = commanded(
      {{0, [](double) { return 150.0; }}, {rudder_channel, [](double) { return 0.2; }}}, 600);
  trial.measured = {{TrialQuantity::north, std::vector<double>(trial.rows(), 0)},
                    {TrialQuantity::r, std::vector<double>(trial.rows(), 0)}};
  trial.first_depth_m = 50;
  const TrialRun run = replayed(wild, trial);
  ASSERT_TRUE(run.diverged(trial));
  EXPECT_GT(run.ended_at_s, 0);
  EXPECT_LT(run.ended_at_s, 600);
  EXPECT_GT(run.ended_at_s, trial.time_s[run.rows - 1]);
  EXPECT_LE(run.ended_at_s, trial.time_s[run.rows] + 1e-9);
  for (const std::vector<double>& ours : run.ours) {
    EXPECT_EQ(ours.size(), run.rows);
    for (const double value : ours) EXPECT_TRUE(std::isfinite(value));
  }
  for (const TrialError& error : errors_of(trial, run).error) EXPECT_EQ(error.n, run.rows - 1);
}

TEST(Trial, RefusesAMultirotorAndOneOfDays) {
  Trial trial = commanded({{0, [](double) { return 100.0; }}}, 1);
  const Vehicle x500 = bundled_vehicle("x500"), otter = bundled_vehicle("otter");
  EXPECT_NE(tests::error_of([&] { return replayed(x500, trial); }).find("multirotor"),
            std::string::npos);
  trial.time_s.back() = 1e5;
  const std::string refused = tests::error_of([&] { return replayed(otter, trial); });
  EXPECT_NE(refused.find("found a trial of 27.8 h"), std::string::npos) << refused;
  EXPECT_NE(refused.find("at most 13.9 h"), std::string::npos) << refused;
}

/// A run of ../shared/data/fossen as a trial: its motion, and the commands that it was given.
Trial fossen_trial(const RunRows& reference, const std::vector<tests::Told>& told) {
  Trial trial = commanded(told, reference.last("t_s"));
  trial.time_s = reference["t_s"];
  for (const char* name : {"north_m", "east_m", "down_m", "roll_rad", "pitch_rad", "yaw_rad",
                           "u_m_s", "v_m_s", "r_rad_s"})
    trial.measured.push_back({measured_name(name)->quantity, reference[name]});
  return trial;
}

void tell(const std::string& name, const TrialErrors& errors) {
  for (const TrialError& error : errors.error)
    if (error.share)
      std::printf("%-28s %-10s rms %9.5f of %9.5f: %6.2f %%\n", name.c_str(),
                  std::string(name_of(error.quantity)).c_str(), error.rms, error.range,
                  100 * *error.share);
}

/// From rest, with commands at nought until the reference begins.
TrialErrors held(const Vehicle& vehicle, const std::string& name, const RunRows& reference,
                 const std::vector<tests::Told>& told, const Triple<double>& current_m_s = {}) {
  Trial trial = fossen_trial(reference, told);
  trial.current_m_s = current_m_s;
  trial.first_depth_m = 10;
  constexpr double hair_s = 1e-6;
  trial.time_s.insert(trial.time_s.begin(), -hair_s);
  for (TrialCommand& command : trial.commands) command.value.insert(command.value.begin(), 0);
  for (TrialColumn& column : trial.measured)
    column.value.insert(column.value.begin(), column.value.front());
  const TrialRun run = replayed(vehicle, trial);
  EXPECT_FALSE(run.diverged(trial));
  const TrialErrors errors = errors_of(trial, run);
  tell(name, errors);
  return errors;
}

TEST(FossenAsATrial, OtterIsWithinTheTolerancesOfItsTest) {
  SLACKWATER_NEEDS_SHARED(shared);
  const Vehicle otter = bundled_vehicle("otter");
  const auto held_to = [&, folder = shared](const std::string& name,
                                            const std::vector<tests::Told>& told,
                                            const Triple<double>& current_m_s = {}) {
    return held(otter, name, reference_run(folder, name), told, current_m_s);
  };
  const TrialErrors straight = held_to("otter_straight_100N", {{0, [](double) { return 67.176; }},
                                                               {1, [](double) { return 67.176; }}});
  EXPECT_LT(of(straight, TrialQuantity::u).share.value(), 0.01);
  EXPECT_LT(straight.place->share.value(), 0.01);
  const TrialErrors turn = held_to(
      "otter_turn_100_80", {{0, [](double) { return 100.0; }}, {1, [](double) { return 80.0; }}});
  EXPECT_LT(of(turn, TrialQuantity::u).share.value(), 0.05);
  EXPECT_LT(of(turn, TrialQuantity::r).share.value(), 0.05);
  const TrialErrors zigzag =
      held_to("otter_zigzag_80_60",
              {{0, [](double t_s) { return std::fmod(t_s + 1e-6, 20) < 10 ? 80.0 : 60.0; }},
               {1, [](double t_s) { return std::fmod(t_s + 1e-6, 20) < 10 ? 60.0 : 80.0; }}});
  EXPECT_LT(of(zigzag, TrialQuantity::yaw).share.value(), 0.05);
  EXPECT_LT(of(zigzag, TrialQuantity::r).share.value(), 0.05);
  const double each_m_s = 0.5 * std::sqrt(0.5);
  const TrialErrors drift = held_to(
      "otter_drift_0p5_to_045", {{0, [](double) { return 0.0; }}, {1, [](double) { return 0.0; }}},
      {each_m_s, each_m_s, 0});
  EXPECT_LT(drift.place->share.value(), 0.01);
}

/// Without its autopilot it does not go straight for long (open_loop.h), and turns at once where
/// Fossen's does not: its first 10 s, by when it has nearly come to its speed.
TEST(FossenAsATrial, RemusComesToItsSpeedAsFast) {
  SLACKWATER_NEEDS_SHARED(shared);
  const Vehicle remus = bundled_vehicle("remus100");
  constexpr double rad_s = 2 * constants::pi / 60;
  const std::vector<std::pair<std::string, tests::Told>> runs{
      {"remus100_straight_600rpm", {0, [](double) { return 600 * rad_s; }}},
      {"remus100_straight_1200rpm", {0, [](double) { return 1200 * rad_s; }}},
      {"remus100_straight_1525rpm", {0, [](double) { return 1525 * rad_s; }}}};
  for (const auto& [name, told] : runs) {
    RunRows reference = reference_run(shared, name);
    for (auto& [column, values] : reference.column) values.resize(51);
    const TrialErrors errors = held(remus, name, reference, {told});
    EXPECT_LT(of(errors, TrialQuantity::u).share.value(), 0.05) << name;
  }
}

}  // namespace
}  // namespace slackwater::twin::trial_test
