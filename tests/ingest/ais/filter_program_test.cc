#include "ingest/ais/filter_program.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <filesystem>
#include <stdexcept>

#include "fields/base/error.h"
#include "fields/base/process/confinement.h"
#include "tests/support/contains.h"

namespace slackwater::tests::filter_program_test {
namespace {

using namespace ingest;
using namespace std::chrono_literals;

FilterProgram shell(const std::string& script, Duration patience = 20s) {
  return {{"sh", "-c", script}, "apt install dash", patience};
}

/// Feeds lines and counts what comes back.
struct Trial {
  std::size_t lines_in = 10;
  std::size_t lines_out = 0;
  std::string last;
  std::string message;  ///< of the Error
  void operator()(const FilterProgram& program) {
    std::size_t fed = 0;
    try {
      run_filter(
          program,
          [&](std::string& input) {
            if (fed == lines_in) return false;
            input += "line " + std::to_string(++fed) + '\n';
            return true;
          },
          [&](std::string_view line) {
            ++lines_out;
            last = line;
          });
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::unavailable);
      message = error.message();
    }
  }
  [[nodiscard]] bool says(const std::string& word) const {
    return message.find(word) != std::string::npos;
  }
};

std::size_t open_descriptors() {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd"))
    count += entry.exists() ? 1U : 0U;
  return count;
}

/// What every end must leave behind: no child, no descriptor.
class FilterProgramTest : public testing::Test {
 protected:
  void SetUp() override { descriptors_ = open_descriptors(); }
  void TearDown() override {
    EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
    EXPECT_EQ(open_descriptors(), descriptors_);
  }

 private:
  std::size_t descriptors_ = 0;
};

TEST_F(FilterProgramTest, MoreThanAnyPipeHoldsGoesThroughAndComesBackWhole) {
  Trial run;
  run.lines_in = 300'000;  // 3.5 MB, and neither end waits for the other
  run(shell("cat"));
  EXPECT_EQ(run.message, "");
  EXPECT_EQ(run.lines_out, 300'000U);
  EXPECT_EQ(run.last, "line 300000");
}

TEST_F(FilterProgramTest, AProgramThatAnswersOnlyAtTheEndIsWaitedFor) {
  Trial run;
  run.lines_in = 100'000;
  run(shell("sort -r | tail -n 1"));
  EXPECT_EQ(run.message, "");
  EXPECT_EQ(run.last, "line 1");
}

TEST_F(FilterProgramTest, NothingToSayIsNoTrouble) {
  Trial run;
  run.lines_in = 0;
  run(shell("cat"));
  EXPECT_EQ(run.message, "");
  EXPECT_EQ(run.lines_out, 0U);
}

TEST_F(FilterProgramTest, AMissingProgramIsNamedWithItsPackage) {
  Trial run;
  run({{"no-such-program-anywhere"}, "apt install it"});
  EXPECT_EQ(run.message,
            "found no program no-such-program-anywhere on the PATH, which is needed here; install "
            "it: apt install it");
}

TEST_F(FilterProgramTest, AKilledProgramIsAnErrorThatNamesTheSignal) {
  Trial run;
  run.lines_in = 300'000;
  run(shell("head -n 5; kill -9 $$"));
  EXPECT_TRUE(run.says("ended by signal 9")) << run.message;
}

TEST_F(FilterProgramTest, AFailureIsAnError) {
  Trial run;
  run(shell("cat; exit 3"));
  EXPECT_TRUE(run.says("failed with exit code 3")) << run.message;
}

TEST_F(FilterProgramTest, AProgramThatStopsReadingIsAnErrorWithoutASignalToUs) {
  Trial run;
  run.lines_in = 300'000;
  run(shell("head -n 5 >/dev/null; exit 0"));
  EXPECT_TRUE(run.says("ended before it had read everything")) << run.message;
}

TEST_F(FilterProgramTest, ASilentProgramIsNotWaitedForForEver) {
  const auto start = std::chrono::steady_clock::now();
  Trial run;
  run(shell("exec sleep 600", 200ms));
  EXPECT_TRUE(run.says("does not answer")) << run.message;
  run(shell("exec sleep 600 >&-", 200ms));
  EXPECT_TRUE(run.says("does not end")) << run.message;
  EXPECT_LT(std::chrono::steady_clock::now() - start, 60s);
}

TEST_F(FilterProgramTest, ALineWithoutEndDoesNotFillTheMemory) {
  Trial run;
  run(shell("exec tr '\\0' x </dev/zero"));
  EXPECT_TRUE(run.says("line without end")) << run.message;
}

TEST_F(FilterProgramTest, NoShellReadsTheArguments) {
  Trial run;
  run.lines_in = 0;
  run({{"printf", "%s\\n", "$(echo harm); `echo harm` && echo harm"}, ""});
  EXPECT_EQ(run.lines_out, 1U);
  EXPECT_EQ(run.last, "$(echo harm); `echo harm` && echo harm");
}

TEST_F(FilterProgramTest, AnExceptionOfOursEndsTheProgram) {
  EXPECT_THROW(run_filter(
                   shell("yes"), [](std::string&) { return false; },
                   [](std::string_view) { throw std::runtime_error("enough"); }),
               std::runtime_error);
  EXPECT_THROW(run_filter(
                   shell("exec sleep 600"),
                   [](std::string&) -> bool { throw std::runtime_error("no input"); },
                   [](std::string_view) {}),
               std::runtime_error);
}

/// What `cat` of a file gives, after the lines of its input.
std::string last_line_of(const std::string& file, bool is_confined) {
  Trial run;
  FilterProgram program{{"cat", "-", file}, "", 20s};
  program.is_confined = is_confined;
  run(program);
  return run.lines_out > run.lines_in ? run.last : run.message;
}

TEST_F(FilterProgramTest, AConfinedProgramHasItsInputAlone) {
  Trial run;
  run.lines_in = 300'000;
  FilterProgram program{{"cat"}, "", 20s};
  program.is_confined = true;
  run(program);
  EXPECT_EQ(run.message, "");
  EXPECT_EQ(run.lines_out, 300'000U);
  EXPECT_NE(last_line_of("/etc/hostname", false), "");
  if (!confinement_of_system().files) GTEST_SKIP() << "this kernel has no Landlock";
  EXPECT_TRUE(contains(last_line_of("/etc/hostname", true), "failed with exit code 1"));
}

TEST_F(FilterProgramTest, AMissingProgramIsNamedWhereItWouldBeConfinedToo) {
  Trial run;
  FilterProgram program{{"no-such-program-anywhere"}, "apt install it"};
  program.is_confined = true;
  run(program);
  EXPECT_TRUE(run.says("found no program no-such-program-anywhere")) << run.message;
}

}  // namespace
}  // namespace slackwater::tests::filter_program_test
