#include "api/door/dds/shared_memory.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <csignal>

#include <fstream>
#include <optional>
#include <set>
#include <thread>

#include "tests/api/door/dds/own_domain.h"
#include "tests/support/comes_true.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::dds::shared_memory_test {
namespace {

using tests::OwnDomain;

using Files = std::set<std::string>;

const std::filesystem::path shared_memory = "/dev/shm";

Files without(const Files& files, const Files& others) {
  Files left;
  std::set_difference(files.begin(), files.end(), others.begin(), others.end(),
                      std::inserter(left, left.end()));
  return left;
}
/// Those that are there.
Files there(const Files& files) {
  Files found;
  for (const std::string& file : files)
    if (std::filesystem::exists(shared_memory / file)) found.insert(file);
  return found;
}

/// Makes files look as if they had lain there for an hour.
void let_lie(const std::filesystem::path& folder, const Files& files) {
  for (const std::string& file : files) {
    std::error_code swept_since;
    std::filesystem::last_write_time(
        folder / file, std::filesystem::file_time_type::clock::now() - std::chrono::hours(1),
        swept_since);
  }
}

/// A participant in a process of its own, which has joined.
class IdleParticipant {
 public:
  explicit IdleParticipant(int domain) {
    int out[2];
    EXPECT_EQ(::pipe2(out, O_CLOEXEC), 0);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, out[1], 1);
    std::string program = SLACKWATER_IDLE_PARTICIPANT, number = std::to_string(domain);
    char* arguments[] = {program.data(), number.data(), nullptr};
    EXPECT_EQ(::posix_spawn(&process_, program.c_str(), &actions, nullptr, arguments, environ), 0);
    ::posix_spawn_file_actions_destroy(&actions);
    ::close(out[1]);
    char ready[6] = {};
    EXPECT_EQ(::read(out[0], ready, sizeof ready), 6) << "it joined";
    ::close(out[0]);
  }
  ~IdleParticipant() { kill(); }
  IdleParticipant(const IdleParticipant&) = delete;
  IdleParticipant& operator=(const IdleParticipant&) = delete;
  /// Of the shared memory that it has mapped, and the locks that it holds, once nothing is added:
  /// what the system tells is of no one moment.
  [[nodiscard]] Files files() const {
    Files files = files_now();
    for (Files before; files != before; files = files_now()) {
      before = files;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return files;
  }
  void kill() {
    if (process_ == 0) return;
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
    process_ = 0;
  }

 private:
  [[nodiscard]] Files files_now() const {
    Files files;
    const auto add = [&](const std::string& path) {
      const std::string start = shared_memory.string() + "/fastrtps_";
      if (path.starts_with(start)) files.insert(path.substr(shared_memory.string().size() + 1));
    };
    const std::filesystem::path process = "/proc/" + std::to_string(process_);
    std::ifstream maps(process / "maps");
    for (std::string line; std::getline(maps, line);)
      if (const auto at = line.find('/'); at != std::string::npos) add(line.substr(at));
    for (const auto& entry : std::filesystem::directory_iterator(process / "fd")) {
      std::error_code closed_since;
      add(std::filesystem::read_symlink(entry.path(), closed_since).string());
    }
    return files;
  }

  pid_t process_ = 0;
};

TEST(SweepSharedMemory, TakesWhatTheKilledLeftAndNothingOfTheLiving) {
  const OwnDomain domain;
  IdleParticipant living(domain.number());
  const Files of_living = living.files();
  IdleParticipant killed(domain.number());
  const Files of_killed = without(killed.files(), of_living);
  ASSERT_FALSE(of_living.empty() || of_killed.empty());
  killed.kill();
  let_lie(shared_memory, of_living);
  // Another test may be sweeping too: what counts is what is left.
  const auto are_swept = [](const Files& files) {
    let_lie(shared_memory, files);
    return tests::comes_true([&] {
      (void)sweep_shared_memory(shared_memory);
      return there(files).empty();
    });
  };
  EXPECT_TRUE(are_swept(of_killed));
  EXPECT_EQ(there(of_living), of_living);
  living.kill();
  EXPECT_TRUE(are_swept(of_living));
}

Files files_of(const std::filesystem::path& folder) {
  Files files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    files.insert(entry.path().filename());
  return files;
}
void touch(const std::filesystem::path& file) { std::ofstream(file) << "x"; }

TEST(SweepSharedMemory, TouchesNothingElse) {
  const tests::TemporaryFolder folder;
  const auto path = folder.path();
  for (const char* name :
       {"fastrtps_0123456789abcdef", "fastrtps_0123456789abcdef_el", "sem.fastrtps_port7410_mutex",
        "fastrtps_port7410", "fastrtps_port7410_el", "fastrtps_port7410_sl", "held", "held_el",
        "fastrtps_alone", "fastrtps_live", "fastrtps_live_el", "sem.other"})
    touch(path / name);
  let_lie(path, files_of(path));
  const int held = ::open((path / "fastrtps_live_el").c_str(), O_RDONLY);
  ASSERT_EQ(::flock(held, LOCK_EX), 0);
  EXPECT_EQ(sweep_shared_memory(path), 6U);
  EXPECT_EQ(files_of(path), (Files{"held", "held_el", "fastrtps_alone", "fastrtps_live",
                                   "fastrtps_live_el", "sem.other"}));
  ::close(held);
}

TEST(SweepSharedMemory, LeavesWhatHasBeenMadeAndIsNotLockedYet) {
  const tests::TemporaryFolder folder;
  const Files made = {"fastrtps_port7410", "fastrtps_port7410_el"};
  for (const std::string& name : made) touch(folder.path() / name);
  EXPECT_EQ(sweep_shared_memory(folder.path()), 0U);
  EXPECT_EQ(files_of(folder.path()), made);
}

TEST(SweepSharedMemory, WaitsForTheNextStartWhileSomebodyStarts) {
  const tests::TemporaryFolder folder;
  const Files left = {"fastrtps_port7410", "fastrtps_port7410_el"};
  auto start = std::make_optional<StartInSharedMemory>(folder.path());
  for (const std::string& name : left) touch(folder.path() / name);
  let_lie(folder.path(), left);
  { const StartInSharedMemory at_the_same_time(folder.path()); }
  EXPECT_EQ(files_of(folder.path()), left) << "the first may be about to lock them";
  start.reset();
  { const StartInSharedMemory later(folder.path()); }
  EXPECT_EQ(files_of(folder.path()), Files());
}

TEST(SweepSharedMemory, WithoutAFolderThereIsNothing) {
  EXPECT_EQ(sweep_shared_memory("/nowhere/at/all"), 0U);
}

}  // namespace
}  // namespace slackwater::dds::shared_memory_test
