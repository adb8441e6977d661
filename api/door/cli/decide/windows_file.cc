#include "api/door/cli/decide/windows_file.h"

#include <algorithm>

#include "api/door/cli/json_place.h"

namespace slackwater::api {
namespace {

constexpr double longest_h = 31 * 24;
constexpr double most_wh = 1e7;

/// A number, or the `p90` of an object.
double planned(const JsonPlace& place, double least, double most) {
  return place.is_object() ? place.at("p90").number(least, most) : place.number(least, most);
}

DayChances::Start read_start(const JsonPlace& task, const JsonPlace& start) {
  DayChances::Start one;
  one.time = start.at("start").time();
  // Flights may have taken from the chance of the limits.
  one.probability = start.at(start.has("worth") ? "worth" : "probability").number(0, 1);
  const JsonPlace& of_duration = start.has("duration_h") ? start : task;
  const double duration_h = planned(of_duration.at("duration_h"), 0, longest_h);
  if (duration_h <= 0) of_duration.at("duration_h").refuse("found 0, expected more");
  one.duration = duration_of_hours(duration_h);
  const JsonPlace& of_energy = start.has("energy_wh") ? start : task;
  if (of_energy.has("energy_wh")) one.energy_wh = planned(of_energy.at("energy_wh"), 0, most_wh);
  return one;
}

DayChances::Task read_task(const JsonPlace& place) {
  DayChances::Task task;
  task.task = place.at("task").text();
  if (place.has("turbine")) task.turbine = place.at("turbine").text();
  if (place.has("contingency_h"))
    task.contingency = duration_of_hours(place.at("contingency_h").number(0, longest_h));
  const JsonPlace starts = place.at("starts");
  for (std::size_t i = 0; i < starts.size(); ++i) {
    DayChances::Start start = read_start(place, starts.item(i));
    if (!task.starts.empty() && start.time <= task.starts.back().time)
      starts.item(i).at("start").refuse("found " + format_utc(start.time) + " after " +
                                        format_utc(task.starts.back().time) +
                                        ", expected times that go forward, each once");
    task.starts.push_back(start);
  }
  return task;
}

}  // namespace

DayChances parse_windows(std::string_view json, std::string name) {
  const nlohmann::json document = parse_document(json, name);
  const JsonPlace root(document, name);
  DayChances chances;
  chances.name = std::move(name);
  chances.site = root.at("site").text();
  chances.day = root.at("day").day();
  const JsonPlace tasks = root.at("tasks");
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    chances.tasks.push_back(read_task(tasks.item(i)));
    const DayChances::Task& last = chances.tasks.back();
    for (std::size_t j = 0; j < i; ++j)
      if (chances.tasks[j].task == last.task && chances.tasks[j].turbine == last.turbine)
        tasks.item(i).refuse("found " + last.task + " at " + last.turbine.value_or("all turbines") +
                             " a second time; keep one");
  }
  return chances;
}

DayChances load_windows(const std::filesystem::path& file) {
  const std::string name = file == "-" ? std::string("standard input") : file.string();
  return parse_windows(document_text(file.string()), name);
}

}  // namespace slackwater::api
