#include <cstring>
#include <filesystem>
#include <fstream>

#include "fields/base/numbers/random.h"
#include "tests/twin/run/run_for_tests.h"
#include "tests/twin/vehicle/changed_vehicle.h"
#include "twin/step/vehicle_step.h"

namespace slackwater::twin::step_kernel_test {
namespace {

/// The vehicles whose files have all that it takes to move: not a body alone.
std::vector<Vehicle> vehicles() {
  const std::filesystem::path data = tests::source_folder() / "data";
  std::vector<Vehicle> out;
  for (const auto& entry : std::filesystem::directory_iterator(data / "vehicles")) {
    std::ifstream file(entry.path());
    const std::string text(std::istreambuf_iterator<char>(file), {});
    if (text.find("\nthruster:") != std::string::npos)
      out.push_back(read_vehicle(entry.path(), data));
  }
  EXPECT_GE(out.size(), 3U);
  out.push_back(tests::lrauv_of_all_kinds());
  return out;
}

/// A vehicle that feels more than all bodies do.
Vehicle with_more(Vehicle vehicle, Rng& rng) {
  vehicle.id += ", with lift and cross-flow";
  Body& body = vehicle.body;
  SpeedLift& lift = body.speed_lift;
  lift.is_there = true;
  lift.without_munk = vehicle.kind == VehicleKind::auv;
  for (double* number : {&lift.y_uv, &lift.y_ur, &lift.n_uv, &lift.n_ur, &lift.z_uw, &lift.z_uq,
                         &lift.m_uw, &lift.m_uq, &lift.k_up})
    *number = -20 * rng.uniform();
  CrossDamping& cross = body.cross_damping;
  cross.is_there = true;
  for (double* number : {&cross.y_r, &cross.n_v, &cross.z_q, &cross.m_w})
    *number = 2 * rng.uniform() - 1;
  CrossFlow& flow = body.cross_flow;
  flow.is_there = true;
  flow.strips = 7;
  for (std::size_t i = 0; i < flow.strips; ++i) {
    flow.x_m[i] = static_cast<double>(i) - 3.2;
    flow.sway_n_s2_m2[i] = 30 * rng.uniform();
    flow.heave_n_s2_m2[i] = 30 * rng.uniform();
  }
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      if (i == j) continue;
      cross.linear.entry[i][j] = 2 * rng.uniform() - 1;
      if (i < j) body.added_mass.entry[i][j] = body.added_mass.entry[j][i] = rng.uniform() - 0.5;
    }
  }
  return vehicle;
}

/// Every number of a value moved by up to `most`, either way.
template <typename Value>
void shake(Value& value, double most, Rng& rng) {
  static_assert(sizeof(Value) % sizeof(double) == 0);
  auto* number = reinterpret_cast<double*>(&value);
  for (std::size_t i = 0; i < sizeof(Value) / sizeof(double); ++i)
    number[i] += most * (2 * rng.uniform() - 1);
}

/// The same bits, or both no number: which NaN comes of two is up to the processor.
bool are_same(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b));
}

struct Lane {
  VehicleState<double> state;
  VehicleCommand<double> command;
  Surroundings<double> around;
};

Lane random_lane(const Vehicle& vehicle, double most, Rng& rng) {
  Lane lane;
  lane.state = placed(vehicle, {3, -4, vehicle.kind == VehicleKind::uav ? -20.0 : 20.0}, 1, 0.7);
  shake(lane.state, most, rng);
  shake(lane.command, most, rng);
  shake(lane.around, most, rng);
  return lane;
}

TEST(StepKernel, IsTheStepOfOneVehicleOnEveryPath) {
  Rng rng(5, "twin/step_kernel_test");
  // From a touch to what no vehicle survives: the last overflow on the way.
  const double sizes[] = {0, 1e-9, 1e-3, 0.1, 1, 30, 1e4, 1e60, 1e160, 1e300};
  std::vector<Vehicle> all = vehicles();
  for (const char* id : {"lrauv_tethys", "wamv16"})
    all.push_back(with_more(tests::bundled_vehicle(id), rng));
  for (const Vehicle& vehicle : all) {
    for (const double held_v : {0.0, 14.0}) {
      const StepPlan plan = plan_step(vehicle, vehicle.largest_step_s, held_v);
      for (int round = 0; round < 30; ++round) {
        std::array<Lane, block_lanes> lanes;
        for (Lane& lane : lanes)
          lane = random_lane(
              vehicle, sizes[static_cast<std::size_t>(rng.uniform() * std::size(sizes))], rng);
        for (const KernelPath path : supported_kernel_paths()) {
          VehicleState<Eight> state;
          VehicleCommand<Eight> command;
          Surroundings<Eight> around;
          for (std::size_t i = 0; i < block_lanes; ++i) {
            put(state, i, lanes[i].state);
            put(command, i, lanes[i].command);
            put(around, i, lanes[i].around);
          }
          step_block_on(path)(vehicle, plan, state, command, around);
          for (std::size_t i = 0; i < block_lanes; ++i) {
            VehicleState<double> one = lanes[i].state;
            step(vehicle, plan, one, lanes[i].command, lanes[i].around);
            const VehicleState<double> eighth = taken(state, i);
            const auto* a = reinterpret_cast<const double*>(&one);
            const auto* b = reinterpret_cast<const double*>(&eighth);
            for (std::size_t n = 0; n < sizeof one / sizeof *a; ++n) {
              ASSERT_TRUE(are_same(a[n], b[n]))
                  << vehicle.id << " on " << name_of(path) << ", round " << round << ", number "
                  << n << ": " << a[n] << " and " << b[n];
            }
          }
        }
      }
    }
  }
}

TEST(StepKernel, WhatIsPutInALaneIsTakenOutOfIt) {
  Rng rng(6, "twin/step_kernel_test");
  VehicleState<Eight> block{};
  std::array<VehicleState<double>, block_lanes> all;
  for (std::size_t i = 0; i < block_lanes; ++i) {
    shake(all[i], 1, rng);
    put(block, i, all[i]);
  }
  for (std::size_t i = 0; i < block_lanes; ++i) {
    const VehicleState<double> out = taken(block, i);
    EXPECT_EQ(std::memcmp(&out, &all[i], sizeof out), 0);
  }
}

}  // namespace
}  // namespace slackwater::twin::step_kernel_test
