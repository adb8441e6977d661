// The same questions with other texts: what changes, what does not, and that nothing is saved.
#include <gtest/gtest.h>

#include "tests/api/door/desk/desk_served.h"
#include "tests/support/contains.h"

namespace slackwater::tests::what_if_test {
namespace {

using nlohmann::json;

class WhatIf : public DeskServed {
 protected:
  static json asked(const json& body) {
    const HttpReply answer = posted("/sites/farm/what-if", body);
    EXPECT_EQ(answer.status, 200) << answer.body;
    return json::parse(answer.body, nullptr, false);
  }
  static std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
  }
};

TEST_F(WhatIf, NothingChangedIsTheSameAnswer) {
  const json same = asked({{"texts", got("/sites/farm/texts")}});
  EXPECT_EQ(same.at("windows").at("tasks"), got("/sites/farm/windows").at("tasks"));
  json plan = same.at("plan"), in_force = got("/sites/farm/plan");
  for (json* one : {&plan, &in_force}) one->erase("time_limit_s");
  EXPECT_EQ(plan, in_force);
  EXPECT_EQ(asked(json::object()).at("windows"), got("/sites/farm/windows"));
}

TEST_F(WhatIf, ALimitIsAnotherLimitAndNothingIsSaved) {
  const auto before = made_->digests();
  const json texts = got("/sites/farm/texts");
  const std::string sheet = texts.at("tasks").at("scour_survey");
  const std::size_t at = sheet.find("current_speed_m_s: ");
  ASSERT_NE(at, std::string::npos) << sheet;
  const std::string limit = sheet.substr(at, sheet.find_first_of(",}\n", at) - at);
  const std::string tight = replaced(sheet, limit, "current_speed_m_s: 0.02");
  const json changed = asked({{"texts", {{"tasks", {{"scour_survey", tight}}}}}});
  const json& task = changed.at("windows").at("tasks").at(0);
  EXPECT_EQ(task.at("task"), "scour_survey");
  EXPECT_EQ(task.at("verdict"), "no-go");
  EXPECT_TRUE(contains(task.at("limits").dump(), "0.02"));
  EXPECT_EQ(changed.at("windows").at("tasks").at(1), got("/sites/farm/windows").at("tasks").at(1))
      << "the other task is as it was";
  EXPECT_FALSE(contains(changed.dump(), "/tmp/")) << "no file of ours is named";
  EXPECT_EQ(made_->digests(), before);
  EXPECT_EQ(got("/sites/farm/texts"), texts);
}

TEST_F(WhatIf, HoursTurbinesAndPlansChangeToo) {
  const json texts = got("/sites/farm/texts");
  const json at_night = asked({{"query", "shift=20:00-24:00&task=cp_anode"}});
  EXPECT_EQ(at_night.at("windows"), got("/sites/farm/windows?shift=20:00-24:00&task=cp_anode"));
  const std::string site = texts.at("site");
  const json named = asked({{"texts", {{"site", replaced(site, "{id: T1", "{id: T9")}}}});
  EXPECT_EQ(named.at("windows").at("tasks").at(0).at("turbine"), "T9");
  EXPECT_TRUE(named.at("plan").is_null()) << "its plan is of a turbine that is gone";
  EXPECT_TRUE(contains(named.at("no_plan").get<std::string>(), "T1")) << named.at("no_plan");
  const json other_plan =
      asked({{"texts", {{"plan", replaced(texts.at("plan"), "name: One look", "name: Another")}}}});
  EXPECT_TRUE(contains(other_plan.at("plan").dump(), "Another"));
}

TEST_F(WhatIf, WhatCannotBeReadIsRefused) {
  const json texts = got("/sites/farm/texts");
  const std::string site = texts.at("site");
  const struct {
    json body;
    const char* words;
  } all[] = {
      {"no json {", "no JSON object"},
      {json::array(), "no JSON object"},
      {{{"text", "x"}}, "another part"},
      {{{"texts", 7}}, "no object"},
      {{{"texts", {{"sight", "x"}}}}, "another text"},
      {{{"texts", {{"site", 7}}}}, "no text"},
      {{{"texts", {{"tasks", {{"../../etc/x", "id: x"}}}}}}, "expected an id"},
      {{{"texts", {{"tasks", {{"scour_survey", "id: ["}}}}}}, "not valid YAML"},
      {{{"texts", {{"site", replaced(site, "id: farm", "id: other")}}}}, "leave its id as it is"},
      {{{"query", "shift=never"}}, "shift: "},
      {{{"query", "task=/etc/passwd"}}, "expected an id"},
  };
  for (const auto& wrong : all) {
    const HttpReply no = posted("/sites/farm/what-if", wrong.body);
    EXPECT_EQ(no.status, 400) << wrong.body << "\n" << no.body;
    EXPECT_TRUE(contains(no.body, wrong.words)) << wrong.body << "\n" << no.body;
    EXPECT_FALSE(contains(no.body, "/tmp/")) << no.body;
  }
  EXPECT_EQ(posted("/sites/nowhere/what-if", json::object()).status, 404);
}

TEST_F(WhatIf, EachPathSaysByWhatItIsServed) {
  const std::pair<const char*, const char*> all[] = {
      {"/sites/farm/what-if", "POST, OPTIONS"},
      {"/sites/farm", "GET, HEAD, OPTIONS"},
      {"/missions", "GET, HEAD, POST, OPTIONS"},
      {"/missions/x/cancel", "POST, OPTIONS"},
      {"/sites/farm/decisions", "GET, HEAD, POST, OPTIONS"}};
  for (const auto& [path, methods] : all) {
    HttpClient client(port_);
    client.send(std::string("OPTIONS ") + path + " HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n");
    const auto reply = client.receive(false);
    ASSERT_TRUE(reply) << path;
    EXPECT_EQ(reply->field("allow"), methods) << path;
  }
}

TEST_F(WhatIf, ForeignPagesAndProxiesAreRefused) {
  for (const char* fields :
       {"Origin: http://elsewhere.example\r\n", "X-Forwarded-For: 10.0.0.1\r\n",
        "Authorization: Bearer wrong\r\nX-Forwarded-For: 10.0.0.1\r\n"}) {
    EXPECT_EQ(posted("/sites/farm/what-if", json::object(), fields).status, 401) << fields;
    EXPECT_EQ(posted("/missions", {{"mission", "name: x"}}, fields).status, 401) << fields;
    EXPECT_EQ(posted("/missions/x/cancel", json::object(), fields).status, 401) << fields;
  }
}

}  // namespace
}  // namespace slackwater::tests::what_if_test
