#include <gnu/libc-version.h>

#include <cstdlib>
#include <fstream>

#include "fields/base/text.h"
#include "tests/twin/run/run_for_tests.h"
#include "twin/run/command.h"

// The five vehicles do what they did, to the last bit: where a term joins the equations that they
// do not have, or code only moves, no figure of theirs moves. The target
// slackwater_record_five_vehicles writes tests/golden/five_vehicles.golden anew, in a commit that
// says which numbers moved and why.

namespace slackwater::tests::yesterdays_bits_test {
namespace {

constexpr double step_s = 0.05;

/// The five in a square kilometre, each with a way that bends, dives or climbs.
std::string five(const std::string& tether) {
  const auto one = [](const char* model, const char* start, const std::string& waypoints,
                      const std::string& more = "") {
    return std::string("  - {name: ") + model + ", model: " + model + ", start: {" + start +
           "}, tasks: [{do: route, waypoints: [" + waypoints + "]}]" + more + "}\n";
  };
  return one("bluerov2_heavy", "north_m: 0, east_m: 5, depth_m: 10, heading_deg: 130",
             "{north_m: 8, east_m: 9, depth_m: 12}, {north_m: 30, east_m: 20, depth_m: 15}",
             tether) +
         one("lrauv_tethys", "north_m: 100, east_m: 0, depth_m: 12",
             "{north_m: 120, east_m: 15, depth_m: 15}, {north_m: 100, east_m: 200, depth_m: 20}") +
         one("x500", "north_m: 200, east_m: 0, height_m: 30",
             "{north_m: 250, east_m: 40, height_m: 35}, {north_m: 250, east_m: 400, "
             "height_m: 30}") +
         one("wamv16", "north_m: -100, east_m: 0, depth_m: 0, heading_deg: 50",
             "{north_m: -80, east_m: 40, depth_m: 0}, {north_m: -200, east_m: 150, depth_m: 0}") +
         one("ctv24", "north_m: -400, east_m: 0, depth_m: 0",
             "{north_m: -300, east_m: 30, depth_m: 0}, {north_m: 600, east_m: 300, depth_m: 0}");
}

twin::ReadyRun in_calm_water() { return ready_of(calm_head(step_s) + five("")); }
twin::ReadyRun in_a_seaway() {
  return ready_of(head(step_s,
                       "{partitions: [{significant_height_m: 1, peak_period_s: 6, from_deg: 250}], "
                       "components: 16}",
                       "dryden") +
                  five(", tether: {top: {north_m: 0, east_m: 0, depth_m: 1}, length_m: 60}"));
}

/// Under their missions for a minute.
std::unique_ptr<twin::Run> sent(twin::ReadyRun ready) {
  auto run = begun(std::move(ready), step_s);
  for (int i = 0; i < 1200; ++i) run->step();
  return run;
}

/// In the seaway for ten seconds with their thrusters by hand, each unlike the next; the rotors
/// near what lifts them.
std::unique_ptr<twin::Run> driven_by_hand() {
  auto run = begun(in_a_seaway(), step_s);
  for (int i = 0; i < 200; ++i) {
    for (std::size_t k = 0; i % 10 == 0 && k < run->agents().size(); ++k) {
      const twin::Vehicle& vehicle = *run->agents()[k].vehicle;
      std::vector<double> share(vehicle.mounts, 0.77);
      for (std::size_t m = 0; vehicle.kind != twin::VehicleKind::uav && m < share.size(); ++m)
        share[m] = m % 3 == 2 ? -0.2 : 0.5 - 0.03 * static_cast<double>(m);
      run->enqueue({0, k, twin::SetThrusters{share}});
    }
    run->step();
  }
  return run;
}

/// To the last bit, but for the kinds of what is no number.
std::string exactly(double value) {
  if (std::isnan(value)) return "nan";
  if (value == 0) return std::signbit(value) ? "-0" : "0";
  return formatted("{:a}", value);
}

/// A line for each column of the log that holds anything: run, vehicle, column, its last row.
void write(const std::string& name, twin::Run& run, std::vector<std::string>& lines) {
  std::vector<double> row(twin::log_row_size());
  for (std::size_t i = 0; i < run.agents().size(); ++i) {
    twin::write_row(run.agents()[i], run.states()[i], run.time_s(), row);
    auto at = row.begin();
    for (const twin::LogVariable& column : twin::log_variables()) {
      const std::span values(at, column.per);
      at += static_cast<std::ptrdiff_t>(column.per);
      const auto is_nothing = [](double value) { return std::isnan(value) || value == 0; };
      if (std::all_of(values.begin(), values.end(), is_nothing)) continue;
      std::string line = name + " " + run.agents()[i].name + " " + column.name;
      for (const double value : values) line += " " + exactly(value);
      lines.push_back(line);
    }
  }
}

std::vector<std::string> lines_of_today() {
  std::vector<std::string> lines;
  write("calm", *sent(in_calm_water()), lines);
  write("seaway", *sent(in_a_seaway()), lines);
  write("by_hand", *driven_by_hand(), lines);
  return lines;
}

std::filesystem::path golden() { return source_folder() / "tests/golden/five_vehicles.golden"; }

std::vector<std::string> lines_of_yesterday() {
  std::ifstream in(golden());
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);)
    if (!line.empty() && line.front() != '#') lines.push_back(line);
  return lines;
}

void record(const std::vector<std::string>& lines) {
  std::ofstream out(golden());
  out << "# title: the last row of the log of the five vehicles of data/vehicles, all its columns\n"
         "# source: recorded from Slackwater itself; nothing else could say that no bit of theirs "
         "moved\n"
         "# operation: tests/twin/run/yesterdays_bits_test.cc; regenerated by the target\n"
         "#   slackwater_record_five_vehicles. 60 s under way in calm water and in a sheared "
         "current with\n"
         "#   waves and gusts, 10 s there with the thrusters by hand\n"
         "# tolerance: none; C's hexadecimal floating point. A column of noughts has no line\n";
  for (const std::string& line : lines) out << line << '\n';
  ASSERT_TRUE(out.flush()) << golden();
}

/// The lines of one that the other does not have.
std::string without(const std::vector<std::string>& lines, const std::vector<std::string>& others) {
  std::string left;
  for (const std::string& line : lines)
    if (std::find(others.begin(), others.end(), line) == others.end()) left += line + '\n';
  return left;
}

/// Sines and exponentials are rounded by the C library, by the instructions that it finds.
bool rounds_as_recorded() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("fma") && std::string(gnu_get_libc_version()) == "2.36";
#else
  return false;
#endif
}

TEST(YesterdaysBits, AreThoseOfVehiclesUnderWay) {
  for (const bool is_calm : {true, false}) {
    twin::ReadyRun ready = is_calm ? in_calm_water() : in_a_seaway();
    const std::vector<twin::AgentState> from = ready.states;
    const auto run = sent(std::move(ready));
    ASSERT_EQ(run->agents().size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) {
      const twin::AgentState& to = run->states()[i];
      const std::string& name = run->agents()[i].name;
      const twin::Triple<double> way = to.vehicle.body.position_m - from[i].vehicle.body.position_m;
      EXPECT_GT(dot(way, way), 9) << name;
      EXPECT_EQ(to.halt, twin::Halt::none) << name;
      EXPECT_EQ(to.vehicle.rudder_rad != 0 && to.vehicle.elevator_rad != 0,
                run->agents()[i].vehicle->kind == twin::VehicleKind::auv)
          << name;
    }
    EXPECT_EQ(run->states()[0].tether_n > 0, !is_calm);
  }
}

TEST(YesterdaysBits, AreTodays) {
  if (!rounds_as_recorded())
    GTEST_SKIP() << "recorded with glibc 2.36 on x86-64 with FMA; another rounds sines otherwise";
  const std::vector<std::string> today = lines_of_today();
  if (std::getenv("SLACKWATER_RECORD_FIVE_VEHICLES") != nullptr) {
    record(today);
    GTEST_SKIP() << "recorded " << golden();
  }
  const std::vector<std::string> yesterday = lines_of_yesterday();
  EXPECT_EQ(without(yesterday, today), "") << "of yesterday alone";
  EXPECT_EQ(without(today, yesterday), "") << "of today alone";
}

}  // namespace
}  // namespace slackwater::tests::yesterdays_bits_test
