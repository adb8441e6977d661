#include "api/door/http/problem.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "fields/base/check.h"

namespace slackwater::tests::problem_test {
namespace {

using namespace slackwater::api::http;

TEST(Problem, HasTheMembersOfRfc7807) {
  const Response response = problem(404, "No collection 'tides'.", "/collections/tides");
  EXPECT_EQ(response.status, 404);
  EXPECT_EQ(response.media_type, "application/problem+json");
  const auto document = nlohmann::json::parse(response.body);
  EXPECT_EQ(document.at("type"), "about:blank");
  EXPECT_EQ(document.at("title"), "Not Found");
  EXPECT_EQ(document.at("status"), 404);
  EXPECT_EQ(document.at("detail"), "No collection 'tides'.");
  EXPECT_EQ(document.at("instance"), "/collections/tides");
  EXPECT_FALSE(nlohmann::json::parse(problem(400, "x", "").body).contains("instance"));
}

TEST(Problem, WhatAClientSentIsQuotedWhateverItsBytes) {
  const auto document = nlohmann::json::parse(problem(400, "found '\xff\x01\"'", "/\xc3").body);
  EXPECT_EQ(document.at("status"), 400);
}

TEST(Problem, EachKindOfErrorHasOneStatus) {
  EXPECT_EQ(status_of(ErrorKind::usage), 400);
  EXPECT_EQ(status_of(ErrorKind::invalid_input), 400);
  EXPECT_EQ(status_of(ErrorKind::not_found), 404);
  EXPECT_EQ(status_of(ErrorKind::unavailable), 503);
  EXPECT_EQ(status_of(ErrorKind::not_converged), 503);
  EXPECT_EQ(status_of(ErrorKind::internal), 500);
}

TEST(Problem, OursAreNotTheClientsToRead) {
  const Response told = problem_of(
      std::make_exception_ptr(Error(ErrorKind::not_found, "no site 'x'; known are a, b")), "/x");
  EXPECT_NE(told.body.find("known are a, b"), std::string::npos);
  EXPECT_EQ(told.for_the_log, "");
  for (const auto& ours : {std::make_exception_ptr(ContractViolation("/src/a.cc:12: bad")),
                           std::make_exception_ptr(Error(ErrorKind::internal, "/src/a.cc:12: bad")),
                           std::make_exception_ptr(std::bad_alloc())}) {
    const Response hidden = problem_of(ours, "/x");
    EXPECT_EQ(hidden.status, 500);
    EXPECT_EQ(hidden.body.find("a.cc"), std::string::npos);
    EXPECT_NE(hidden.for_the_log, "");
  }
  EXPECT_EQ(problem_of(std::make_exception_ptr(3), "").status, 500);
}

}  // namespace
}  // namespace slackwater::tests::problem_test
