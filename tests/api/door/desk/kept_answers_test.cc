#include "api/door/desk/kept_answers.h"

#include <gtest/gtest.h>

#include <future>

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

}  // namespace
}  // namespace slackwater::tests::kept_answers_test
