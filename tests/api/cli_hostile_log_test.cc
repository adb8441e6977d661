// Logs and forecasts of others that crash the library that reads them: the programs that users run
// read them in a process of its own too, whatever threads their libraries began.
#include <gtest/gtest.h>

#include "tests/support/contains.h"
#include "tests/support/shared_data.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_hostile_log_test {
namespace {

const std::filesystem::path hostile =
    source_folder() / "tests" / "fuzz" / "corpus" / "apart" / "hdf5_damaged_link_table.nc";

// With ASan the library always crashes of it, without it most often says that it is damaged.
TEST(HostileLog, EndsItsReaderAlone) {
  const StoreForTests store;
  write_bytes(store.file("run.yaml"),
              "name: hostile\nseed: 1\nduration: 1min\nstep_s: 0.1\nlog_every_s: 1\n"
              "water: {forecast: {file: " +
                  hostile.string() +
                  "}}\n"
                  "vehicles:\n"
                  "  - name: rov\n"
                  "    model: bluerov2_heavy\n"
                  "    start: {north_m: 0, east_m: 0, depth_m: 5, heading_deg: 0}\n"
                  "    speed_m_s: 0.5\n"
                  "    tasks: [{do: hold}]\n");
  const std::vector<std::vector<std::string>> commands{
      {"score", hostile.string()},
      {"replay", hostile.string()},
      {"render", hostile.string(), "--sensor", "uav_camera", "--out", store.file("out").string()},
      {"simulate", store.file("run.yaml").string(), "--out", store.file("log.nc").string()}};
  for (const auto& command : commands) {
    const ProgramResult result = store.run(command);
    EXPECT_EQ(result.exit_code, 3) << command[0] << ": " << result.err;
    EXPECT_TRUE(contains(result.err, "hdf5_damaged_link_table.nc")) << command[0] << result.err;
    EXPECT_TRUE(contains(result.err, "damaged")) << command[0] << ": " << result.err;
  }
}

}  // namespace
}  // namespace slackwater::tests::cli_hostile_log_test
