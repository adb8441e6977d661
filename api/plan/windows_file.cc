#include "api/plan/windows_file.h"

#include <algorithm>

#include "api/plan/json_place.h"
#include "fields/base/error.h"

namespace slackwater::api {
namespace {

constexpr double longest_h = 31 * 24;
constexpr double most_wh = 1e7;

/// A number, or the `p90` of an object.
double planned(const JsonPlace& place, double least, double most) {
  return place.is_object() ? place.at("p90").number(least, most) : place.number(least, most);
}

Duration hours(double value) {
  return std::chrono::duration_cast<Duration>(
      std::chrono::duration<double, std::ratio<3600>>(value));
}

template <typename Parse>
auto read(const JsonPlace& place, Parse parse) {
  try {
    return parse(place.text());
  } catch (const Error& problem) {
    place.refuse(problem.message());
  }
}

WindowsFile::Start read_start(const JsonPlace& task, const JsonPlace& start) {
  WindowsFile::Start one;
  one.time = read(start.at("start"), [](const std::string& text) { return parse_utc(text); });
  // Flights may have taken from the chance of the limits.
  one.probability = start.at(start.has("worth") ? "worth" : "probability").number(0, 1);
  const JsonPlace& of_duration = start.has("duration_h") ? start : task;
  const double duration_h = planned(of_duration.at("duration_h"), 0, longest_h);
  if (duration_h <= 0) of_duration.at("duration_h").refuse("found 0, expected more");
  one.duration = hours(duration_h);
  const JsonPlace& of_energy = start.has("energy_wh") ? start : task;
  if (of_energy.has("energy_wh")) one.energy_wh = planned(of_energy.at("energy_wh"), 0, most_wh);
  return one;
}

WindowsFile::Task read_task(const JsonPlace& place) {
  WindowsFile::Task task;
  task.task = place.at("task").text();
  if (place.has("turbine")) task.turbine = place.at("turbine").text();
  if (place.has("contingency_h"))
    task.contingency = hours(place.at("contingency_h").number(0, longest_h));
  const JsonPlace starts = place.at("starts");
  for (std::size_t i = 0; i < starts.size(); ++i) {
    WindowsFile::Start start = read_start(place, starts.item(i));
    if (!task.starts.empty() && start.time <= task.starts.back().time)
      starts.item(i).at("start").refuse("found " + format_utc(start.time) + " after " +
                                        format_utc(task.starts.back().time) +
                                        ", expected times that go forward, each once");
    task.starts.push_back(start);
  }
  return task;
}

}  // namespace

const WindowsFile::Task* WindowsFile::find(const std::string& wanted,
                                           const std::string& turbine) const {
  const Task* of_all = nullptr;
  for (const Task& one : tasks) {
    if (one.task != wanted) continue;
    if (one.turbine == turbine) return &one;
    if (!one.turbine) of_all = &one;
  }
  return of_all;
}

WindowsFile parse_windows(std::string_view json, std::string name) {
  const nlohmann::json document = parse_document(json, name);
  const JsonPlace root(document, name);
  WindowsFile file;
  file.name = std::move(name);
  file.site = root.at("site").text();
  file.day = read(root.at("day"), [](const std::string& text) { return parse_day(text); });
  const JsonPlace tasks = root.at("tasks");
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    file.tasks.push_back(read_task(tasks.item(i)));
    const WindowsFile::Task& last = file.tasks.back();
    for (std::size_t j = 0; j < i; ++j)
      if (file.tasks[j].task == last.task && file.tasks[j].turbine == last.turbine)
        tasks.item(i).refuse("found " + last.task + " at " + last.turbine.value_or("all turbines") +
                             " a second time; keep one");
  }
  return file;
}

WindowsFile load_windows(const std::filesystem::path& file) {
  const std::string name = file == "-" ? std::string("standard input") : file.string();
  return parse_windows(document_text(file.string()), name);
}

}  // namespace slackwater::api
