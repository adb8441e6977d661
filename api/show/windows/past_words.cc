#include "api/show/windows/past_words.h"

#include <array>
#include <nlohmann/json.hpp>

#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

/// By the order of `PastVerdicts::classes`.
constexpr std::array<const char*, 4> class_names{"go", "marginal", "no-go", "below_a_tenth"};

}  // namespace

std::string past_text(const TaskWindows& task) {
  if (task.calibration.starts == 0) return {};
  std::string text =
      counted(task.past.mornings, "past morning") +
      formatted(
          ": starts were given {:.0f} % on average, and {:.0f} % held; these chances are "
          "corrected by that. ",
          100 * task.calibration.said, 100 * task.calibration.held);
  text += task.past.goes == 0
              ? std::string("None of them was a go")
              : formatted("{} of {} goes held", task.past.goes_held, task.past.goes);
  if (task.past.lost > 0)
    text += "; on " + counted(task.past.lost, "other morning") + " the best start held";
  return text + ".";
}

std::string past_text(const WindowsAnswer& answer) {
  twin::PastVerdicts all;
  for (const TaskWindows& task : answer.tasks) all += task.past;
  if (all.mornings == 0)
    return "no past morning of this site could be held against what came: the chances are as the "
           "futures say";
  return (all.goes == 0 ? std::string("no task was a go")
                        : formatted("of {} goes {} held", all.goes, all.goes_held)) +
         "; " + counted(all.lost, "time") + " a task was not a go and its best start held, over " +
         counted(all.mornings, "past morning");
}

json past_json(const TaskWindows& task) {
  if (task.calibration.starts == 0) return nullptr;
  json classes = json::array();
  for (std::size_t c = 0; c < task.past.classes.size(); ++c) {
    const twin::SaidAndCame& of = task.past.classes[c];
    if (of.starts == 0) continue;
    const auto n = static_cast<double>(of.starts);
    classes.push_back({{"said_to_be", class_names[c]},
                       {"starts", of.starts},
                       {"said", of.said / n},
                       {"held", static_cast<double>(of.held) / n}});
  }
  return {{"mornings", task.past.mornings},
          {"starts", task.calibration.starts},
          {"said_by_futures", task.calibration.said},
          {"held", task.calibration.held},
          {"shift", task.calibration.shift},
          {"slope", task.calibration.slope},
          {"goes", task.past.goes},
          {"goes_held", task.past.goes_held},
          {"others_that_held", task.past.lost},
          {"classes", classes}};
}

}  // namespace slackwater::api
