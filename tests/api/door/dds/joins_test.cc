// Readers that come and go, as nodes do that are started again and again.
#include <gtest/gtest.h>
#include <malloc.h>

#include <filesystem>
#include <fstream>

#include "api/door/dds/participant.h"
#include "tests/api/door/dds/cdr_by_hand.h"
#include "tests/api/door/dds/inbox.h"
#include "tests/api/door/dds/own_domain.h"
#include "tests/support/asked_number.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::joins_test {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool counts_heap = false;  // they have one of their own, of which mallinfo2 knows nothing
#else
constexpr bool counts_heap = true;
#endif

std::size_t entries_of(const char* folder) {
  const std::filesystem::directory_iterator all(folder);
  return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

/// What this process has in use. The readers are in another.
struct InUse {
  std::size_t heap_bytes = ::mallinfo2().uordblks;
  std::size_t files = entries_of("/proc/self/fd");
  std::size_t threads = entries_of("/proc/self/task");
};

class Joins : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Over, Joins, testing::Bool(), [](const auto& is_udp_only) {
  return is_udp_only.param ? "Udp" : "SharedMemory";
});

TEST_P(Joins, LeaveNothingBehind) {
  const int joins = asked_number("SLACKWATER_JOINS", 50);
  const int first_ones = std::max(25, joins / 20);  // until all pools have their size
  constexpr int of_a_process = 25;
  const TemporaryFolder folder;
  const OwnDomain domain;
  dds::DomainSettings settings;
  settings.domain = domain.number();
  settings.is_loopback_only = settings.is_udp_only = GetParam();
  std::atomic<int> nodes_left = 0;
  dds::Participant writer(settings);
  writer.on_lost([&](const std::string&) { ++nodes_left; });
  const auto latched =
      writer.publish_on({"/test/latched", "std_msgs/msg/String", "", {true, true, 1}});
  const auto stream =
      writer.publish_on({"/test/stream", "std_msgs/msg/String", "", {true, false, 1}});
  const dds::Bytes message = HandWriter().string("told").bytes();
  writer.send(latched, message);
  std::atomic<bool> is_over = false;
  std::thread telling([&] {
    for (; !is_over; std::this_thread::sleep_for(std::chrono::milliseconds(5)))
      writer.send(stream, message);
  });
  const auto let_join = [&](int count) {
    nodes_left = 0;
    const int processes = count / of_a_process;
    for (int i = 0; i < processes; ++i) {
      const int exit_code = wait_for_program(
          start_other_program(SLACKWATER_VISITING_READERS,
                              {std::to_string(domain.number()), std::to_string(of_a_process),
                               GetParam() ? "udp" : "shared-memory"},
                              folder / "said"));
      EXPECT_EQ(exit_code, 0) << std::ifstream(folder / "said").rdbuf();
    }
    const int nodes = 2 * processes;
    // An announcement that comes behind the farewell makes one leave twice.
    EXPECT_TRUE(comes_true([&] { return nodes_left >= nodes && !writer.is_heard(stream); }))
        << nodes_left << " of " << nodes << " were seen to leave";
    return InUse();
  };
  const InUse at_first = let_join(first_ones);
  const InUse at_last = let_join(joins);
  is_over = true;
  telling.join();
  std::printf("%d joins after %d: heap %zu -> %zu B%s, files %zu -> %zu, threads %zu -> %zu\n",
              joins, first_ones, at_first.heap_bytes, at_last.heap_bytes,
              counts_heap ? "" : " (not counted under a sanitizer)", at_first.files, at_last.files,
              at_first.threads, at_last.threads);
  EXPECT_EQ(at_last.files, at_first.files);
  EXPECT_EQ(at_last.threads, at_first.threads);
  // Some messages on their way more or less, and what is known of one that left late; of a reader
  // alone that is kilobytes. Fast DDS counts what it sends by address and port, and forgets none:
  // new processes take the ports of those that left, so a machine's are met but once.
  if (counts_heap) {
    EXPECT_LT(at_last.heap_bytes, at_first.heap_bytes + 32'768);
  }
}

}  // namespace
}  // namespace slackwater::tests::joins_test
