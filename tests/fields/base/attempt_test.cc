#include "fields/base/attempt.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

#include "fields/base/check.h"

namespace slackwater::attempt_test {
namespace {

TEST(Attempt, WhatIsDoneHasNoFailure) {
  bool is_done = false;
  EXPECT_FALSE(attempt([&] { is_done = true; }));
  EXPECT_TRUE(is_done);
}

TEST(Attempt, AnErrorKeepsItsKindAndItsWords) {
  const auto failure = attempt([] { throw Error(ErrorKind::not_converged, "no minimum"); });
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->kind, ErrorKind::not_converged);
  EXPECT_EQ(failure->why, "no minimum");
}

TEST(Attempt, ABugIsCalledOneAndSaysWhereItIsWithoutTheFoldersOfItsBuild) {
  const auto failure = attempt([] { expects(false, "a fetch > 0"); });
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->kind, ErrorKind::internal);
  EXPECT_EQ(failure->why.find("internal error, please report it (attempt_test.cc:"), 0U)
      << failure->why;
  EXPECT_NE(failure->why.find(": a fetch > 0)"), std::string::npos) << failure->why;
  EXPECT_EQ(failure->why.find('/'), std::string::npos) << failure->why;
}

TEST(Attempt, AnyOtherExceptionIsABugToo) {
  const auto failure = attempt([] { throw std::out_of_range("vector::at"); });
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->kind, ErrorKind::internal);
  EXPECT_NE(failure->why.find("vector::at"), std::string::npos);
}

TEST(Attempt, MemoryThatHasRunOutStopsEverything) {
  EXPECT_THROW((void)attempt([] { throw std::bad_alloc(); }), std::bad_alloc);
}

}  // namespace
}  // namespace slackwater::attempt_test
