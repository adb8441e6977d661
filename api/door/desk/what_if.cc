#include "api/door/desk/what_if.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "api/ask/morning/morning.h"
#include "api/door/desk/asked_words.h"
#include "api/door/desk/kept_answers.h"
#include "api/door/desk/own_folder.h"
#include "api/door/desk/site_list.h"
#include "api/show/windows/windows_answer.h"
#include "fields/base/attempt.h"
#include "fields/base/error.h"
#include "fields/base/whole_file.h"

namespace slackwater::api::desk {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Texts in place of others, as files that the questions can name.
class OtherTexts {
 public:
  void set_site(const std::string& yaml) {
    site_ = folder_.path() / "site.yaml";
    write_text(site_, yaml);
    shown_[site_.string()] = "the changed site";
  }
  void set_task(const std::string& id, const std::string& yaml) {
    expect_id("tasks", id);
    const fs::path file = folder_.path() / (id + ".task.yaml");
    write_text(file, yaml);
    tasks_[id] = file.string();
    shown_[file.string()] = id;
  }
  void set_plan(const std::string& yaml) {
    plan_ = folder_.path() / "plan.yaml";
    write_text(plan_, yaml);
    shown_[plan_.string()] = "the changed plan";
  }
  [[nodiscard]] const fs::path& site() const noexcept { return site_; }
  [[nodiscard]] const fs::path& plan() const noexcept { return plan_; }
  [[nodiscard]] std::string task(const std::string& id) const {
    const auto found = tasks_.find(id);
    return found == tasks_.end() ? id : found->second;
  }
  [[nodiscard]] bool has_tasks() const noexcept { return !tasks_.empty(); }

  /// Names of our files are nobody's business: ids instead.
  [[nodiscard]] std::string shown(std::string text) const {
    for (const auto& [file, name] : shown_)
      for (std::size_t at = text.find(file); at != std::string::npos; at = text.find(file, at))
        text.replace(at, file.size(), name);
    return text;
  }
  [[nodiscard]] json shown(const json& value) const {
    if (value.is_string()) return shown(value.get<std::string>());
    json out = value;
    if (value.is_structured())
      for (auto& part : out) part = shown(part);
    return out;
  }

 private:
  OwnFolder folder_;
  fs::path site_, plan_;
  std::map<std::string, std::string> tasks_, shown_;
};

Error not_as_expected(const std::string& found) {
  return {ErrorKind::usage, "found " + found +
                                R"(, expected {"texts": {"site": YAML, "tasks": {ID: YAML}, )"
                                R"("plan": YAML}, "query": "..."}, each part or none)"};
}

std::string text_in(const json& value, const char* what) {
  if (!value.is_string()) throw not_as_expected(std::string(what) + " that is no text");
  return value.get<std::string>();
}

void read_texts(const json& texts, OtherTexts& into) {
  if (!texts.is_object()) throw not_as_expected("texts that are no object");
  for (const auto& [name, value] : texts.items()) {
    if (name == "site") {
      into.set_site(text_in(value, "a site"));
    } else if (name == "plan") {
      into.set_plan(text_in(value, "a plan"));
    } else if (name == "tasks" && value.is_object()) {
      for (const auto& [id, sheet] : value.items()) into.set_task(id, text_in(sheet, "a task"));
    } else {
      throw not_as_expected("another text");
    }
  }
}

/// The same site by another description: another one's forecast would be another answer.
Site changed_site(const Answers& from, const std::string& id, const OtherTexts& texts) {
  Site site = texts.site().empty() ? described_site(id, from.store_folder)
                                   : find_site(texts.site().string(), {});
  if (site.id != id)
    throw Error(ErrorKind::invalid_input, "found a site of the id " + site.id + ", expected " + id +
                                              "; leave its id as it is");
  return site;
}

json changed_windows(const Answers& from, const std::string& id, const std::string& query,
                     const OtherTexts& texts) {
  const Site site = changed_site(from, id, texts);
  WindowsWords words = windows_words(id, query);
  if (!texts.site().empty()) words.site = texts.site().string();
  if (words.tasks.empty() && texts.has_tasks()) words.tasks = site.tasks;
  for (std::string& task : words.tasks) task = texts.task(task);
  WindowsQuestion question = windows_question(words, {"", from.store_folder, from.now});
  question.may_leave_out = true;
  const std::string mark = mark_of(from.store_folder, from.data_folder);
  question.site = id;
  from.water->lend(mark, question);
  question.site = words.site;
  const WindowsAnswer answer = windows_of(question, from.store_folder);
  question.site = id;
  if (texts.site().empty()) from.water->keep(mark, question, answer);
  return windows_json(question, answer);
}

/// The same work at the turbines of those names.
void move_to(const Site& site, const fs::path& file, PlanFile& plan) {
  for (PlanFile::Work& work : plan.work) {
    for (std::size_t& turbine : work.turbines) {
      const std::string& name = plan.site.turbines[turbine].id;
      const auto found = std::find_if(site.turbines.begin(), site.turbines.end(),
                                      [&](const TurbinePlace& one) { return one.id == name; });
      if (found == site.turbines.end())
        throw Error(ErrorKind::invalid_input, "found work at turbine " + name +
                                                  " in the plan, which the changed site does not "
                                                  "have; change the plan too");
      turbine = static_cast<std::size_t>(found - site.turbines.begin());
    }
  }
  plan.site = site;
  plan.site_place = file.string();
}

json changed_plan(const Answers& from, const std::string& id, const OtherTexts& texts,
                  const fs::path& file) {
  PlanFile plan = load_plan_file(file, from.store_folder);
  if (plan.site.id != id)
    throw Error(ErrorKind::invalid_input,
                "found a plan of site " + plan.site.id + ", expected one of " + id);
  if (!texts.site().empty()) move_to(changed_site(from, id, texts), texts.site(), plan);
  for (PlanFile::Work& work : plan.work) work.task = texts.task(work.task);
  WindowsQuestion question;
  question.practice = AlphaPractice::of_tables({});
  question.site = id;
  from.water->lend(mark_of(from.store_folder, from.data_folder), question);
  constexpr double limit_s = 1;  // somebody waits for it with a hand on the mouse
  return plan_of(from, plan, std::move(question), twin::VerdictRule{}.marginal, limit_s);
}

}  // namespace

json what_if(const Answers& from, const std::string& id, const std::string& body) {
  static_cast<void>(described_site(id, from.store_folder));
  const json asked = json::parse(body, nullptr, false);
  if (!asked.is_object()) throw not_as_expected("a body that is no JSON object");
  OtherTexts texts;
  std::string query;
  for (const auto& [name, value] : asked.items()) {
    if (name == "texts")
      read_texts(value, texts);
    else if (name == "query")
      query = text_in(value, "a query");
    else
      throw not_as_expected("another part");
  }
  try {
    json out{{"windows", changed_windows(from, id, query, texts)},
             {"plan", nullptr},
             {"no_plan", nullptr}};
    const fs::path file = texts.plan().empty() ? plan_of_site(id, from.store_folder) : texts.plan();
    if (file.empty()) {
      out["no_plan"] = "the site has no plan";
    } else if (const auto failure =
                   attempt([&] { out["plan"] = changed_plan(from, id, texts, file); })) {
      out["no_plan"] = failure->why;
    }
    return texts.shown(out);
  } catch (const Error& problem) {
    throw Error(problem.kind(), texts.shown(problem.message()));
  }
}

}  // namespace slackwater::api::desk
