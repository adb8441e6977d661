// Rehearsals that are asked for over HTTP: they wait their turn, are told as they go, and end.
#include <gtest/gtest.h>

#include "tests/api/door/desk/desk_served.h"
#include "tests/support/contains.h"

namespace slackwater::tests::mission_jobs_test {
namespace {

using nlohmann::json;
using namespace std::chrono_literals;

class MissionJobs : public DeskServed {
 protected:
  static std::string submitted(const json& body) {
    const HttpReply taken = posted("/missions", body);
    EXPECT_EQ(taken.status, 202) << taken.body;
    const std::string id = json::parse(taken.body).at("id");
    EXPECT_EQ(taken.field("location"), "/missions/" + id);
    return id;
  }
  static json ended(const std::string& id) {
    json job;
    EXPECT_TRUE(comes_true(
        [&] {
          job = got("/missions/" + id);
          return job.at("state") != "waiting" && job.at("state") != "flying";
        },
        120s))
        << job;
    return job;
  }
  static inline const std::string mission_ =
      "name: A look\nsite: farm\nturbines: [T1]\ntasks: [scour_survey]\n"
      "start: 2025-03-04T08:00:00Z\nseed: 7\nduration: 2h\nstep_s: 0.1\n";
};

/// How long it took is of the clock.
json without_times(json result) {
  for (const char* key : {"wall_s", "first_answer_s"}) result.erase(key);
  return result;
}

TEST_F(MissionJobs, SayWhatTheCommandSays) {
  const std::string id = submitted({{"mission", mission_}, {"members", 2}});
  const json job = ended(id);
  ASSERT_EQ(job.at("state"), "done") << job;
  EXPECT_EQ(job.at("share"), 1);
  made_->write("mission.yaml", mission_);
  EXPECT_EQ(without_times(job.at("result")),
            without_times(told({"rehearse", path("mission.yaml"), "--members", "2"})));
  EXPECT_EQ(submitted({{"mission", mission_}, {"members", 2}}), id) << "it is flown once";
  EXPECT_NE(submitted({{"mission", mission_}, {"members", 1}}), id);
  EXPECT_GE(got("/missions").at("missions").size(), 2U);
}

TEST_F(MissionJobs, MayBeCancelled) {
  const std::string id = submitted({{"mission", mission_}, {"members", 900}});
  ASSERT_TRUE(comes_true([&] { return got("/missions/" + id).at("state") == "flying"; }, 60s));
  EXPECT_EQ(posted("/missions/" + id + "/cancel", json::object()).status, 202);
  const json job = ended(id);
  EXPECT_EQ(job.at("state"), "cancelled");
  EXPECT_LT(job.at("share").get<double>(), 1);
  EXPECT_TRUE(job.at("result").is_null());
  EXPECT_EQ(posted("/missions/unknown/cancel", json::object()).status, 404);
}

TEST_F(MissionJobs, SayWhyTheyFailed) {
  const json job = ended(submitted({{"mission", "name: A look\nsite: nowhere\n"}}));
  EXPECT_EQ(job.at("state"), "failed");
  EXPECT_TRUE(contains(job.at("why").get<std::string>(), "nowhere")) << job;
  EXPECT_FALSE(contains(job.at("why").get<std::string>(), "/tmp/")) << job;
}

TEST_F(MissionJobs, OfAnotherFormAreRefused) {
  for (const json& body :
       {json("no json {"), json::array(), json::object(), json{{"mission", 7}},
        json{{"mission", "name: x"}, {"members", 0}}, json{{"mission", "x"}, {"members", 1e9}},
        json{{"mission", "x"}, {"starts", {7}}}, json{{"mission", "x"}, {"starts", {"noon"}}},
        json{{"mission", "x"}, {"more", 1}}})
    EXPECT_EQ(posted("/missions", body).status, 400) << body;
}

TEST_F(MissionJobs, AreRefusedWhereTooManyWait) {
  std::vector<std::string> ids;
  int status = 202;
  for (int i = 0; i < 40 && status == 202; ++i) {
    const HttpReply taken =
        posted("/missions", {{"mission", mission_ + "# " + std::to_string(i)}, {"members", 900}});
    status = taken.status;
    if (status == 202) ids.push_back(json::parse(taken.body).at("id"));
  }
  EXPECT_EQ(status, 503);
  EXPECT_GE(ids.size(), 16U);
  for (const std::string& id : ids)
    EXPECT_EQ(posted("/missions/" + id + "/cancel", json::object()).status, 202);
  for (const std::string& id : ids) EXPECT_EQ(ended(id).at("state"), "cancelled");
}

}  // namespace
}  // namespace slackwater::tests::mission_jobs_test
