// Whoever takes over what reads a file finds nothing to do with it. Each deed here is one that
// works where nobody is confined, so that its failure is the confinement's.
#include "fields/base/process/confinement.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <thread>

#include "fields/base/process/run_apart.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::confinement_test {
namespace {

namespace fs = std::filesystem;

struct Confined : testing::Test {
  Confined() {
    fs::create_directory(folder / "staging");
    std::ofstream(folder / "given") << "given";
    std::ofstream(folder / "secret") << "secret";
    allowance.reach.readable = {folder / "given", folder / "not there"};
    allowance.reach.writable = {folder / "staging"};
  }
  void SetUp() override {
    if (!confinement_of_system().calls) GTEST_SKIP() << "this kernel filters no calls";
  }
  /// What a deed gives in a confined process.
  bool does(const std::function<bool()>& deed) const {
    const Apart apart =
        run_apart(allowance, [&](const TellShare&) { return std::string(deed() ? "y" : "n"); }, {});
    EXPECT_EQ(apart.end, Apart::End::answered) << apart.signal;
    return apart.answer == "y";
  }
  void expect_lost(const char* what, const std::function<bool()>& deed) const {
    EXPECT_TRUE(deed()) << what << " does not work here, so that nothing is shown";
    EXPECT_FALSE(does(deed)) << what;
  }
  const TemporaryFolder folder;
  Allowance allowance;
};

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

bool opens_socket(int family) {
  const Descriptor socket(::socket(family, SOCK_STREAM, 0));
  return socket.is_open();
}

bool runs_a_program() {
  std::string name = "/bin/true";
  char* const arguments[] = {name.data(), nullptr};
  pid_t child = 0;
  if (::posix_spawn(&child, name.c_str(), nullptr, nullptr, arguments, nullptr) != 0) return false;
  int status = 1;
  ::waitpid(child, &status, 0);
  return status == 0;
}

bool forks() {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  return child > 0 && ::waitpid(child, nullptr, 0) == child;
}

TEST_F(Confined, HasNoNetwork) {
  expect_lost("a connection", [] { return opens_socket(AF_INET); });
  expect_lost("a local socket", [] { return opens_socket(AF_UNIX); });
}

TEST_F(Confined, RunsNothingElse) {
  expect_lost("a program", runs_a_program);
  expect_lost("a process", forks);
  expect_lost("memory that is run", [] {
    void* const at = ::mmap(nullptr, 4096, PROT_READ | PROT_WRITE | PROT_EXEC,
                            MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    return at != MAP_FAILED && ::munmap(at, 4096) == 0;
  });
  expect_lost("memory that is run later", [] {
    void* const at =
        ::mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    const bool is_run = ::mprotect(at, 4096, PROT_READ | PROT_EXEC) == 0;
    ::munmap(at, 4096);
    return is_run;
  });
}

TEST_F(Confined, ReachesNoOtherProcess) {
  const pid_t ours = ::getpid();
  expect_lost("a signal", [=] { return ::kill(ours, 0) == 0; });
  ::prctl(PR_SET_PTRACER, PR_SET_PTRACER_ANY, 0, 0, 0);
  static volatile int number = 7;
  expect_lost("memory of another process", [=] {
    int seen = 0;
    iovec here{&seen, sizeof seen}, there{const_cast<int*>(&number), sizeof number};
    return ::process_vm_readv(ours, &here, 1, &there, 1, 0) > 0 && seen == 7;
  });
}

// The kernel would send it on, whoever is meant.
TEST_F(Confined, HasNobodySignalledOfItsFiles) {
  const pid_t ours = ::getpid();
  expect_lost("an owner", [=] {
    const Descriptor file(::open("/dev/null", O_RDONLY));
    return ::fcntl(file.is_open() ? file.value() : STDIN_FILENO, F_SETOWN, ours) == 0;
  });
}

TEST_F(Confined, HasNoDescriptorsOfOurs) {
  const Descriptor out(::dup(STDOUT_FILENO));
  const Descriptor file(::open((folder / "out").c_str(), O_RDWR | O_CREAT, 0600));
  ASSERT_GE(::dup2(file.value(), STDOUT_FILENO), 0);
  const bool is_written = does([] { return ::write(STDOUT_FILENO, "escape", 6) == 6; });
  ::dup2(out.value(), STDOUT_FILENO);
  EXPECT_TRUE(is_written) << "to nobody";
  EXPECT_EQ(text_of(folder / "out"), "");
  const Descriptor secret(::open((folder / "secret").c_str(), O_RDONLY));
  expect_lost("an open file", [&] {
    char letter = 0;
    return ::pread(secret.value(), &letter, 1, 0) == 1;
  });
}

TEST_F(Confined, ReachesItsFilesAlone) {
  if (!confinement_of_system().files) GTEST_SKIP() << "this kernel has no Landlock";
  expect_lost("another file", [&] { return text_of(folder / "secret") == "secret"; });
  expect_lost("a file of the system", [] { return !text_of("/etc/passwd").empty(); });
  expect_lost("a list of names", [&] {
    std::error_code problem;
    return fs::directory_iterator(folder.path(), problem) != fs::directory_iterator();
  });
  expect_lost("writing what is given",
              [&] { return Descriptor(::open((folder / "given").c_str(), O_WRONLY)).is_open(); });
  expect_lost("cutting what is given",
              [&] { return ::truncate((folder / "given").c_str(), 5) == 0; });
  expect_lost("a file beside", [&] {
    return Descriptor(::open((folder / "new").c_str(), O_WRONLY | O_CREAT, 0600)).is_open();
  });
  expect_lost("a way out by a name", [&] {
    const fs::path name = folder / "staging" / "way";
    ::unlink(name.c_str());
    return ::symlink("/etc/passwd", name.c_str()) == 0 && !text_of(name).empty();
  });
  expect_lost("a second name", [&] {
    const fs::path name = folder / "staging" / "second";
    ::unlink(name.c_str());
    return ::link((folder / "secret").c_str(), name.c_str()) == 0;
  });
  EXPECT_EQ(text_of(folder / "given"), "given");
}

TEST_F(Confined, ReadsWritesAndReckonsAsBefore) {
  EXPECT_TRUE(does([&] { return text_of(folder / "given") == "given"; }));
  EXPECT_TRUE(does([&] {
    const fs::path file = folder / "staging" / "file", moved = folder / "staging" / "moved";
    std::ofstream(file) << "written";
    fs::rename(file, moved);
    return text_of(moved) == "written" && fs::remove(moved) &&
           fs::create_directory(folder / "staging" / "below");
  }));
  EXPECT_TRUE(does([] {
    std::atomic<int> sum = 0;
    std::vector<std::thread> threads;
    for (int i = 1; i <= 4; ++i) threads.emplace_back([&, i] { sum += i; });
    for (std::thread& thread : threads) thread.join();
    return sum == 10;
  }));
  EXPECT_TRUE(does([] { return std::vector<char>(100 << 20U, 'x').back() == 'x'; }));
}

// As a decoder of others is run: a program at its place, with nothing but what it is given.
TEST_F(Confined, AProgramIsConfinedToo) {
  const auto output_of = [&](const Reach& reach, const fs::path& file) {
    const Confinement confinement(reach);
    const fs::path out = folder / "out";
    const pid_t child = ::fork();
    if (child == 0) {
      const int output = ::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
      ::dup2(output, STDOUT_FILENO);
      if (!confinement.apply()) ::_exit(1);
      ::execl("/bin/cat", "cat", file.c_str(), nullptr);
      ::_exit(1);
    }
    ::waitpid(child, nullptr, 0);
    return text_of(out);
  };
  Reach reach;
  reach.programs = {"/bin/cat", "/lib64/ld-linux-x86-64.so.2", "/lib/ld-linux-aarch64.so.1"};
  reach.readable = {"/lib", "/usr/lib", "/etc/ld.so.cache", folder / "given"};
  EXPECT_EQ(output_of(reach, folder / "given"), "given");
  if (confinement_of_system().files) EXPECT_EQ(output_of(reach, folder / "secret"), "");
  Reach without = reach;
  without.programs = {"/bin/true"};
  if (confinement_of_system().files) EXPECT_EQ(output_of(without, folder / "given"), "");
}

}  // namespace
}  // namespace slackwater::tests::confinement_test
