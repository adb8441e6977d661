#include <cstring>
#include <filesystem>
#include <fstream>

#include "fields/base/numbers/random.h"
#include "tests/twin/run/run_for_tests.h"
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
  return out;
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
  for (const Vehicle& vehicle : vehicles()) {
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
