// The disk is full while `slackwater live` records.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/api/door/live/live_records.h"
#include "tests/support/comes_true.h"
#include "tests/support/started_program.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::full_disk_live_test {
namespace {

using namespace std::chrono_literals;

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// No file of the process grows beyond so much from now on, as on a disk that is full.
void fill_disk(pid_t process, rlim_t bytes) {
  const rlimit most{bytes, RLIM_INFINITY};
  ASSERT_EQ(::prlimit(process, RLIMIT_FSIZE, &most, nullptr), 0);
}

TEST(FullDiskOfALiveRun, IsSaidAndTheRunGoesOnAndItsRecordsStayReadable) {
  const TemporaryFolder folder;
  const auto mcap = folder / "run.mcap", rosbag = folder / "run", log = folder / "run.nc";
  // A disk answers with an error, a limit with a signal first; who is started takes this on.
  const auto before = std::signal(SIGXFSZ, SIG_IGN);
  StartedProgram run(start_program({"live", live_scenario(), "--real-time-factor", "10", "--record",
                                    mcap, "--record", rosbag, "--out", log, "--json"},
                                   {}, folder / "out", folder / "err"));
  std::signal(SIGXFSZ, before);
  EXPECT_TRUE(comes_true([&] { return messages_told(rosbag) > 0; }, 60s));
  const std::size_t told = messages_told(rosbag);
  // Its definitions alone are 10 kB: what counts are the messages, of a copy that does not grow.
  EXPECT_TRUE(comes_true(
      [&] {
        std::error_code none;
        std::filesystem::copy_file(mcap, folder / "copy.mcap",
                                   std::filesystem::copy_options::overwrite_existing, none);
        return !none && expect_even_clock(messages_of(folder / "copy.mcap")) > 10;
      },
      60s));
  fill_disk(run.process(), std::filesystem::file_size(mcap));

  for (const auto& record : {mcap, rosbag}) {
    const std::string said =
        "the recording " + record.string() + " ends here, the run goes on without it: ";
    EXPECT_TRUE(
        comes_true([&] { return text_of(folder / "err").find(said) != std::string::npos; }, 30s))
        << said << "\nwas not said:\n"
        << text_of(folder / "err");
  }
  const auto in_mcap = messages_of(mcap), in_rosbag = messages_of(rosbag);
  std::this_thread::sleep_for(500ms);
  fill_disk(run.process(), RLIM_INFINITY);
  ASSERT_EQ(run.end(SIGINT), 5) << text_of(folder / "err");
  EXPECT_NE(text_of(folder / "err").find("its recording is not: found " + mcap.string()),
            std::string::npos);

  // What there was when it was full is what there is; of all later steps the log alone knows.
  for (const auto* record : {&in_mcap, &in_rosbag}) EXPECT_GT(expect_even_clock(*record), 10U);
  EXPECT_GE(in_rosbag.size(), told);
  EXPECT_EQ(messages_of(mcap), in_mcap);
  EXPECT_EQ(messages_of(rosbag), in_rosbag);
  const auto result = nlohmann::json::parse(text_of(folder / "out"));
  const auto told_of = [](const auto& record, const auto& messages) {
    return nlohmann::json{
        {"path", record.string()}, {"messages", messages.size()}, {"complete", false}};
  };
  EXPECT_EQ(result.at("recordings"),
            (nlohmann::json{told_of(mcap, in_mcap), told_of(rosbag, in_rosbag)}));
  const auto steps = result.at("punctuality").at("steps").get<std::size_t>();
  EXPECT_GT(steps, expect_even_clock(in_mcap) + 20);
  EXPECT_GT(steps, expect_even_clock(in_rosbag) + 20);
  EXPECT_EQ(run_program({"replay", log.string()}).exit_code, 0);
}

}  // namespace
}  // namespace slackwater::tests::full_disk_live_test
