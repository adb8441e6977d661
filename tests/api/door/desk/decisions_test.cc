// Decisions that are signed at the page: as the command files them, or not at all.
#include <gtest/gtest.h>

#include <future>

#include "tests/api/door/desk/desk_served.h"
#include "tests/support/contains.h"

namespace slackwater::tests::desk_decisions_test {
namespace {

using nlohmann::json;

class DeskDecisions : public DeskServed {
 protected:
  static json said(const std::string& start) {
    return {{"task", "scour_survey"},
            {"start", start},
            {"decided", "go"},
            {"by", "Änne O'Name"},
            {"note", "swell dies by six"},
            {"hand_over", "the tow leaves at noon"}};
  }
  static json filed(const json& body) {
    const HttpReply answer = posted("/sites/farm/decisions", body);
    EXPECT_EQ(answer.status, 201) << answer.body;
    return json::parse(answer.body, nullptr, false);
  }
  static json with(json body, const std::string& key, json value) {
    body[key] = std::move(value);
    return body;
  }
  static json with_id(const json& list, const json& id) {
    for (const json& one : list.at("decisions"))
      if (one.at("id") == id) return one;
    ADD_FAILURE() << "no decision " << id;
    return {};
  }
};

TEST_F(DeskDecisions, AreFiledAsTheCommandFilesThemToTheByte) {
  const StoreForTests other(made_->file("other-store"));
  std::filesystem::copy(made_->store(), other.store(), std::filesystem::copy_options::recursive);
  const json all[] = {
      with(said("2025-03-04T08:00Z"), "at", "2025-03-04T06:05:00Z"),
      with(with(said("2025-03-04T09:17Z"), "turbine", "T1"), "at", "2025-03-04T06:06:00Z"),
      with(with(said("2025-03-04T08:00Z"), "decided", "no_go"), "at", "2025-03-04T09:00:00Z"),
      with(with(said("2025-03-06T23:30Z"), "task", "cp_anode"), "at", "2025-03-04T06:05:00Z")};
  for (const json& body : all) {
    filed(body);
    std::vector<std::string> words{"decide", "--site", "farm"};
    for (const char* key : {"task", "turbine", "start", "by", "note", "at"})
      if (body.contains(key)) words.insert(words.end(), {std::string("--") + key, body.at(key)});
    words.insert(words.end(), {"--hand-over", body.at("hand_over")});
    words.emplace_back(body.at("decided") == "go" ? "--go" : "--no-go");
    const ProgramResult by_command = other.run(words);
    ASSERT_EQ(by_command.exit_code, 0) << by_command.err;
  }
  const std::vector<std::string> list{"decisions", "--site", "farm", "--at", "2025-03-04T10:00:00Z",
                                      "--json"};
  const ProgramResult ours = made_->run(list), theirs = other.run(list);
  ASSERT_EQ(ours.exit_code, 0) << ours.err;
  EXPECT_EQ(ours.out, theirs.out);
  EXPECT_EQ(json::parse(ours.out).at("decisions").size(), std::size(all));
}

TEST_F(DeskDecisions, TheAnswerIsTheOneOfTheList) {
  const json before = got("/sites/farm/decisions");
  const json one = filed(said("2025-03-04T10:00Z"));
  EXPECT_EQ(one.at("by"), "Änne O'Name");
  EXPECT_EQ(one.at("forecast").at("issued"), "2025-03-04T05:00:00Z");
  EXPECT_FALSE(one.at("said").at("probability").is_null()) << one;
  EXPECT_FALSE(one.at("recorded_by_clock").get<bool>()) << "serve --at: the clock was set";
  EXPECT_EQ(one.at("recorded_at").get<std::string>().substr(0, 14), "2025-03-04T06:");
  const json after = got("/sites/farm/decisions");
  EXPECT_EQ(after.at("decisions").size(), before.at("decisions").size() + 1) << "no kept answer";
  EXPECT_EQ(with_id(after, one.at("id")), one);
  EXPECT_EQ(
      with_id(told({"decisions", "--site", "farm", "--at", "2025-03-04T07:00:00Z"}), one.at("id")),
      one);
}

TEST_F(DeskDecisions, OfTwoAtOnceTheSecondMeetsTheFirst) {
  const auto both = [](json first, json second) {
    auto one =
        std::async(std::launch::async, [&] { return posted("/sites/farm/decisions", first); });
    HttpReply two = posted("/sites/farm/decisions", second);
    return std::pair(one.get(), std::move(two));
  };
  const json go = with(said("2025-03-04T11:00Z"), "in_place_of", nullptr);
  const auto [one, two] = both(go, with(with(go, "decided", "no_go"), "by", "B. Other"));
  EXPECT_EQ(one.status + two.status, 201 + 409) << one.body << "\n" << two.body;
  const HttpReply& refused = one.status == 409 ? one : two;
  const json filed_one = json::parse(one.status == 201 ? one.body : two.body);
  EXPECT_TRUE(contains(
      refused.body, "found decision " + filed_one.at("id").dump() + " on this start meanwhile, "))
      << refused.body;
  EXPECT_TRUE(contains(refused.body, filed_one.at("by").get<std::string>())) << refused.body;
  const json later = filed(with(go, "in_place_of", filed_one.at("id")));
  EXPECT_FALSE(with_id(got("/sites/farm/decisions"), filed_one.at("id")).at("counts").get<bool>());
  EXPECT_TRUE(with_id(got("/sites/farm/decisions"), later.at("id")).at("counts").get<bool>());
  // Who does not say what he saw is filed, as by the command: both, one after the other.
  const json blind = said("2025-03-04T11:30Z");
  const auto [three, four] = both(blind, blind);
  EXPECT_EQ(three.status, 201) << three.body;
  EXPECT_EQ(four.status, 201) << four.body;
  const json ids[] = {json::parse(three.body).at("id"), json::parse(four.body).at("id")};
  const json list = got("/sites/farm/decisions");
  EXPECT_NE(with_id(list, ids[0]).at("counts"), with_id(list, ids[1]).at("counts"));
}

TEST_F(DeskDecisions, WhatCannotBeFiledLeavesTheStoreAsItWas) {
  const json good = said("2025-03-04T12:00Z");
  const auto without = [&](const char* key) {
    json body = good;
    body.erase(key);
    return body;
  };
  const json seen = got("/sites/farm/report").at("forecast").at("sha256");
  const auto before = made_->digests();
  const struct {
    json body;
    int status;
    const char* words;
  } all[] = {
      {"no json {", 400, "no JSON object"},
      {json::array({good}), 400, "no JSON object"},
      {without("task"), 400, "found no task"},
      {without("start"), 400, "found no start"},
      {without("decided"), 400, "found no decided"},
      {without("by"), 400, "found no by"},
      {with(good, "more", "x"), 400, "another part"},
      {with(good, "by", 7), 400, "no text"},
      {with(good, "by", "  "), 400, "by: found no name"},
      {with(good, "by", std::string(201, 'a')), 400, "by: found 201"},
      {with(good, "by", "A\nB"), 400, "by: "},
      {with(good, "note", "x\u202ey"), 400, "note: "},
      {with(good, "hand_over", "x\ny"), 400, "hand_over: "},
      {with(good, "decided", "perhaps"), 400, "'perhaps'"},
      {with(good, "start", "at noon"), 400, "start: "},
      {with(good, "start", "2025-03-04T12:00:30Z"), 400, "start: found 2025-03-04T12:00:30Z"},
      {with(good, "at", "then"), 400, "at: "},
      {with(good, "in_place_of", "x"), 400, "another part"},
      {with(good, "task", "/etc/passwd"), 400, "expected an id"},
      {with(good, "task", "no_such_task"), 404, "no_such_task"},
      {with(good, "turbine", "T9"), 404, "turbine: found T9"},
      {with(good, "start", "2031-01-01T00:00Z"), 404, "covers the start"},
      {with(good, "at", "2025-03-01T00:00:00Z"), 404, "the first was issued later"},
      {with(good, "forecast", std::string(64, '0')), 409, "issued 2025-03-04T05:00:00Z"},
      {with(good, "in_place_of", 12345), 409, "none counts"},
  };
  for (const auto& wrong : all) {
    const HttpReply no = posted("/sites/farm/decisions", wrong.body);
    EXPECT_EQ(no.status, wrong.status) << wrong.body << "\n" << no.body;
    EXPECT_EQ(no.field("content-type"), "application/problem+json") << wrong.body;
    EXPECT_TRUE(contains(no.body, wrong.words)) << wrong.body << "\n" << no.body;
    EXPECT_FALSE(contains(no.body, made_->store().string())) << no.body;
    EXPECT_FALSE(contains(no.body, "--")) << no.body << ": here are no options";
  }
  EXPECT_EQ(posted("/sites/nowhere/decisions", good).status, 404);
  EXPECT_EQ(posted("/sites/bare/decisions", good).status, 404) << "it has no forecast";
  for (const char* fields :
       {"Origin: http://elsewhere.example\r\n", "X-Forwarded-For: 10.0.0.1\r\n"})
    EXPECT_EQ(posted("/sites/farm/decisions", good, fields).status, 401) << fields;
  EXPECT_EQ(made_->digests(), before);
  filed(with(with(good, "forecast", seen), "in_place_of", nullptr));
}

}  // namespace
}  // namespace slackwater::tests::desk_decisions_test
