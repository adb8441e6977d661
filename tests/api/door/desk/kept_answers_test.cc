#include "api/door/desk/kept_answers.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <fstream>
#include <future>
#include <mutex>
#include <thread>

#include "fields/base/spare_memory.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::kept_answers_test {
namespace {

using api::desk::KeptAnswers;
namespace http = api::http;

http::Response said(const std::string& body) {
  http::Response response;
  response.body = body;
  return response;
}

/// Who has just written must not be told what somebody else began to work out before.
TEST(KeptAnswersOfTheDesk, WhatIsBeingWorkedOutIsForgottenToo) {
  const TemporaryFolder folder;
  KeptAnswers kept(folder / "store", folder / "data", [] { return UtcTime(); });
  std::promise<void> begun, may_end;
  auto slow = std::async(std::launch::async, [&] {
    return kept.answer("decisions", [&] {
      begun.set_value();
      may_end.get_future().wait();
      return said("before");
    });
  });
  begun.get_future().wait();
  kept.forget();
  EXPECT_EQ(kept.answer("decisions", [] { return said("after"); }).body, "after");
  may_end.set_value();
  EXPECT_EQ(slow.get().body, "before") << "who asked before is told what was before";
  EXPECT_EQ(kept.answer("decisions", [] { return said("worked out again"); }).body, "after");
}

TEST(KeptAnswersOfTheDesk, AreBoundedInBytesAndTheOldestGoFirst) {
  const TemporaryFolder folder;
  KeptAnswers kept(
      folder / "store", folder / "data", [] { return UtcTime(); }, 1000);
  int made = 0;
  const auto ask = [&](const std::string& question, std::size_t bytes) {
    const std::size_t told = kept.answer(question,
                                         [&] {
                                           ++made;
                                           return said(std::string(bytes, 'x'));
                                         })
                                 .body.size();
    EXPECT_EQ(told, bytes);
    EXPECT_LE(kept.kept_bytes(), 1000U);
  };
  ask("first", 400);
  ask("second", 400);
  ask("third", 400);
  EXPECT_EQ(kept.kept_bytes(), 800U);
  ask("second", 400);
  ask("third", 400);
  EXPECT_EQ(made, 3) << "both are kept";
  ask("first", 400);
  EXPECT_EQ(made, 4) << "it went";
  ask("too much", 1001);
  ask("too much", 1001);
  EXPECT_EQ(made, 6) << "it is answered, and not kept";
  kept.forget();
  EXPECT_EQ(kept.kept_bytes(), 0U);
}

/// Pages of this process that are in memory, as Linux counts them.
double resident_mb() {
  std::ifstream statm("/proc/self/statm");
  double all = 0, resident = 0;
  statm >> all >> resident;
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
}

/// Frees a large block first, after which glibc would keep up to twice as much at the end of
/// a thread's heap, where no trimming reaches.
TEST(KeptAnswersOfTheDesk, DoNotKeepTheEndOfAHeap) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer's heap keeps what was freed, to tell who uses it";
#endif
  hold_little_spare_memory();
  const TemporaryFolder folder;
  KeptAnswers kept(folder / "store", folder / "data", [] { return UtcTime(); });
  const double before_mb = resident_mb();
  std::thread asker([&] {
    (void)kept.answer("a question", [&] {
      std::vector<std::string> block(1, std::string(30'000'000, 'x'));
      block.clear();
      const std::vector<std::string> pieces(50'000, std::string(1000, 'x'));
      return said(pieces.back().substr(0, 5));
    });
  });
  asker.join();
  EXPECT_LT(resident_mb(), before_mb + 15);
}

/// Four at once, each of which takes 60 MB in small pieces to make a short answer, and leaves a
/// little above them, so that the heap cannot end lower.
TEST(KeptAnswersOfTheDesk, DoNotKeepTheMemoryThatTheyWereMadeIn) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer's heap keeps what was freed, to tell who uses it";
#endif
  const TemporaryFolder folder;
  KeptAnswers kept(folder / "store", folder / "data", [] { return UtcTime(); });
  const double before_mb = resident_mb();
  double most_mb = 0;
  std::mutex measuring;
  std::vector<std::string> left;
  std::vector<std::thread> askers;
  for (int asker = 0; asker < 4; ++asker)
    askers.emplace_back([&, asker] {
      (void)kept.answer("question " + std::to_string(asker), [&] {
        std::vector<std::string> pieces;
        for (int i = 0; i < 60000; ++i) pieces.emplace_back(1000, 'x');
        const std::lock_guard lock(measuring);
        left.emplace_back(1000, 'x');
        most_mb = std::max(most_mb, resident_mb());
        return said("short");
      });
    });
  for (std::thread& asker : askers) asker.join();
  EXPECT_GT(most_mb, before_mb + 50);
  EXPECT_LT(resident_mb(), before_mb + 25);
}

}  // namespace
}  // namespace slackwater::tests::kept_answers_test
