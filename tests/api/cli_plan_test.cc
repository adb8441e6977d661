// `slackwater plan`: what to do when, for people and programs, and all that can be wrong with it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/refusal.h"
#include "tests/support/shared_data.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_plan_test {
namespace {

using nlohmann::json;
using Arguments = std::vector<std::string>;

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

class PlanCommand : public testing::Test {
 protected:
  const std::filesystem::path plans_ = source_folder() / "data" / "plans";
  const std::string plan_ = (plans_ / "anodes_and_blades.yaml").string();
  const std::string windows_ = (plans_ / "made_up_windows.json").string();
  const std::string yaml_ = text_of(plan_);

  ProgramResult run(Arguments arguments) const {
    arguments.insert(arguments.begin(), "plan");
    return store_.run(arguments);
  }
  json answer(Arguments arguments) const {
    arguments.emplace_back("--json");
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return json::accept(result.out) ? json::parse(result.out) : json();
  }
  /// Told in one line that holds the words, on stderr, and nothing else.
  void expect_refused(const Arguments& arguments, int exit_code,
                      const std::vector<std::string>& words) const {
    expect_refusal(run(arguments), exit_code, words);
  }
  /// The plan with one thing changed is refused so.
  void expect_yaml_refused(const std::string& from, const std::string& to,
                           const std::vector<std::string>& words) const {
    const std::string file = store_.write("plan.yaml", replaced(yaml_, from, to));
    expect_refused({file, "--windows", windows_}, 3, words);
  }

  StoreForTests store_;
};

TEST_F(PlanCommand, PlansTheExampleAndProvesIt) {
  const json found = answer({plan_, "--windows", windows_});
  EXPECT_EQ(found.at("schema"), "plan/1");
  EXPECT_EQ(found.at("site"), "example_farm");
  EXPECT_EQ(found.at("day"), "2025-06-02");
  EXPECT_EQ(found.at("proven"), true);
  EXPECT_EQ(found.at("gap"), 0);
  EXPECT_EQ(found.at("least_probability"), 0.5) << "what is planned is at least marginal";
  EXPECT_EQ(found.at("jobs").size() + found.at("left").size(), 7U);
  double value = 0;
  for (const json& job : found.at("jobs")) {
    value += job.at("priority").get<double>() * job.at("probability").get<double>();
    EXPECT_LT(parse_utc(job.at("start").get<std::string>()),
              parse_utc(job.at("end").get<std::string>()));
    for (const char* key : {"job", "task", "turbine", "vessel", "crew"})
      EXPECT_TRUE(job.at(key).is_string()) << key;
  }
  EXPECT_NEAR(found.at("value").get<double>(), value, 1e-9);
  for (const json& left : found.at("left")) EXPECT_NE(left.at("why"), "");
  EXPECT_EQ(found.at("vessels").size(), 2U);
  EXPECT_FALSE(found.contains("changes"));
  EXPECT_EQ(answer({plan_, "--windows", windows_, "--chance", "0"}).at("least_probability"),
            nullptr);
}

TEST_F(PlanCommand, SaysWhoDoesWhatWhenAndWhatIsLeft) {
  const ProgramResult result = run({plan_, "--windows", windows_});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  for (const char* word : {"no plan is worth more", "cp_anode@A01", "rov1", "blue", "Saint-Malo",
                           "charge", "left:", "biofouling@F01", "70 %, marginal", "h at sea"})
    EXPECT_NE(result.out.find(word), std::string::npos) << word << "\n" << result.out;
}

TEST_F(PlanCommand, TakesNoStartOfLessThanTheChanceAskedForAndTheSameEachTime) {
  const Arguments arguments{plan_, "--windows", windows_, "--chance", "0.9"};
  const json found = answer(arguments);
  EXPECT_EQ(found.at("least_probability"), 0.9);
  EXPECT_FALSE(found.at("jobs").empty());
  for (const json& job : found.at("jobs")) EXPECT_GE(job.at("probability").get<double>(), 0.9);
  EXPECT_EQ(answer(arguments), found);
  EXPECT_LE(found.at("value"), answer({plan_, "--windows", windows_}).at("value"));
}

TEST_F(PlanCommand, ReadsWindowsFromStandardInput) {
  const std::string command = program_path().string() + " plan " + plan_ +
                              " --windows - --json < " + windows_ + " > " + store_.path("out.json");
  EXPECT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(json::parse(text_of(store_.path("out.json"))).at("jobs"),
            answer({plan_, "--windows", windows_}).at("jobs"));
}

TEST_F(PlanCommand, SaysWhatChangedSinceAnEarlierPlan) {
  const ProgramResult before = run({plan_, "--windows", windows_, "--json"});
  const std::string old = store_.write("old.json", before.out);
  json same = answer({plan_, "--windows", windows_, "--since", old});
  for (const json& change : same.at("changes")) EXPECT_EQ(change.at("change"), "kept");
  // The morning at A02 turned bad, and B02 is not asked for any more.
  json windows = json::parse(text_of(windows_));
  for (json& task : windows.at("tasks")) {
    if (task.at("task") != "blade_scan" || task.at("turbine") != "A02") continue;
    for (json& start : task.at("starts")) start.at("probability") = 0.1;
  }
  const std::string anew = store_.write("anew.json", windows.dump());
  const std::string plan = store_.write(
      "plan.yaml", replaced(yaml_,
                            "- {task: cp_anode, turbines: [B02], priority: 1, skills: [rov], "
                            "energy_wh: 200}",
                            ""));
  const json found = answer({plan, "--windows", anew, "--since", old});
  std::map<std::string, json> by_job;
  for (const json& change : found.at("changes")) by_job[change.at("job")] = change;
  EXPECT_EQ(by_job.at("cp_anode@B02").at("change"), "no longer asked for");
  EXPECT_NE(by_job.at("blade_scan@A02").at("change"), "kept");
  EXPECT_NE(by_job.at("blade_scan@A02").at("why").get<std::string>().find("fell from"),
            std::string::npos)
      << by_job.at("blade_scan@A02");
  const ProgramResult text = run({plan, "--windows", anew, "--since", old});
  EXPECT_NE(text.out.find("since the earlier plan:"), std::string::npos);
}

TEST_F(PlanCommand, RefusesACommandLineThatMakesNoSense) {
  expect_refused({plan_}, 4, {"no --windows", "no store"});
  expect_refused({plan_, "--windows", windows_, "--chance", "80"}, 2, {"--chance"});
  expect_refused({plan_, "--windows", windows_, "--time-limit", "0"}, 2, {"--time-limit 0"});
  expect_refused({plan_, "--windows", windows_, "--time-limit", "-5"}, 2, {"--time-limit"});
  expect_refused({plan_, "--windows", windows_, "--time-limit", "1.2.3"}, 2, {"1.2.3"});
  expect_refused({store_.path("none.yaml"), "--windows", windows_}, 4, {"none.yaml"});
  expect_refused({plan_, "--windows", store_.path("none.json")}, 4, {"none.json"});
  expect_refused({plan_, "--windows", windows_, "--since", store_.path("none.json")}, 4,
                 {"none.json"});
  expect_refused({plan_, "--windows", store_.store().parent_path().string()}, 3, {"folder"});
}

TEST_F(PlanCommand, RefusesWhatNobodyCanDo) {
  expect_yaml_refused("id: drone1, kind: uav", "id: drone1, kind: auv",
                      {"no vehicle that could do blade_scan", "it takes a uav"});
  // The drone is on one vessel, whoever can fly it on the other.
  expect_refused(
      {store_.write("plan.yaml",
                    replaced(replaced(yaml_, "skills: [uav], shift: 05:30-17:30, vessel: ctv1",
                                      "skills: [uav], shift: 05:30-17:30, vessel: ctv2"),
                             "skills: [rov, uav]", "skills: [rov]")),
       "--windows", windows_},
      3, {"blade_scan@A01", "no vessel that could carry"});
  expect_yaml_refused("priority: 2, skills: [uav]", "priority: 2, skills: [welding]",
                      {"skills: found welding", "no crew has"});
  expect_yaml_refused("priority: 2, skills: [uav]", "priority: 2, skills: [uav, rov, welding]",
                      {"welding"});
  expect_yaml_refused("contingency: 1h", "contingency: 9h",
                      {"biofouling@F01", "longer than the day"});
}

TEST_F(PlanCommand, RefusesAPlanFileThatIsWrongWithFileLineAndKey) {
  expect_yaml_refused("turbines: [A01, B01]", "turbines: [A01, B99]",
                      {"plan.yaml:", "turbines: found B99", "did you mean"});
  expect_yaml_refused("{id: rov2,", "{id: rov1,", {"vehicles[1].id: found rov1 twice"});
  expect_yaml_refused("{id: red,", "{id: blue,", {"crews[2].id: found blue twice"});
  expect_yaml_refused("{id: ctv2,", "{id: ctv1,", {"vessels[1].id: found ctv1 twice"});
  expect_yaml_refused("turbines: [B02]", "turbines: [A01]", {"cp_anode at A01 twice"});
  expect_yaml_refused("swap: 10min", "swap: -10min", {"swap: found '-10min'"});
  expect_yaml_refused("charge: 3h", "charge: -3h", {"charge: found '-3h'"});
  expect_yaml_refused("hours: 05:00-19:00", "hours: 20:00-06:00", {"goes over midnight"});
  expect_yaml_refused("hours: 05:00-19:00", "hours: all day", {"hours: found 'all day'"});
  expect_yaml_refused("speed_kn: 20", "speed_kn: -20", {"speed_kn: found -20"});
  expect_yaml_refused("speed_kn: 20", "sped_kn: 20", {"speed_kn"});
  expect_yaml_refused("priority: 4", "prioritie: 4", {"did you mean 'priority'"});
  expect_yaml_refused("priority: 4", "priority: -4", {"priority: found -4"});
  expect_yaml_refused("vessel: ctv2, swap", "vessel: ctv3, swap",
                      {"vessel: found ctv3", "one of the vessels: ctv1, ctv2"});
  expect_yaml_refused("chargers: [deck]", "chargers: [quay]", {"chargers: found quay"});
  expect_yaml_refused("task: biofouling", "task: bio_fouling", {"did you mean 'biofouling'"});
  expect_yaml_refused("kind: uav", "kind: plane", {"kind: found plane", "rov, auv, usv, uav"});
  expect_yaml_refused("grid: 15min", "grid: 7min", {"does not divide a day"});
  expect_yaml_refused("vessel: ctv2, swap: 15min", "vessel: ctv2, battery: rov_pack, swap: 15min",
                      {"list them apart"});
  expect_yaml_refused("daylight: civil", "daylight: moon", {"daylight: found"});
  expect_yaml_refused("day: 2025-06-02", "day: 2025-06-03",
                      {"found windows of 2025-06-02", "expected those of 2025-06-03"});
  expect_yaml_refused("site: example_farm", "site: hollandse_kust_noord", {"turbines"});
}

TEST_F(PlanCommand, RefusesWindowsAndEarlierPlansThatAreNone) {
  const std::string text = text_of(windows_);
  const auto refused = [&](const std::string& windows, const std::vector<std::string>& words) {
    expect_refused({plan_, "--windows", store_.write("w.json", windows)}, 3, words);
  };
  refused(text.substr(0, text.size() / 2), {"w.json: not valid JSON", "written to the end"});
  refused("", {"not valid JSON"});
  refused(replaced(text, "example_farm", "alpha_ventus"), {"found windows of alpha_ventus"});
  refused(replaced(text, "biofouling", "cleaning"), {"found no starts of biofouling at F01"});
  const std::string plan = store_.write("old.json", "{\"site\": \"example_farm\"}");
  expect_refused({plan_, "--windows", windows_, "--since", plan}, 3, {"old.json: found no 'day'"});
  expect_refused({plan_, "--windows", windows_, "--since", windows_}, 3, {"found no 'jobs'"});
}

TEST_F(PlanCommand, TellsTroubleAsJsonToo) {
  const ProgramResult result = run({plan_, "--windows", store_.path("none.json"), "--json"});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_EQ(json::parse(result.out).at("error").at("kind"), "not_found");
}

}  // namespace
}  // namespace slackwater::tests::cli_plan_test
