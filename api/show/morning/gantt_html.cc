#include "api/show/morning/gantt_html.h"

#include <algorithm>

#include "api/ask/windows/worth.h"
#include "api/show/morning/morning_clock.h"
#include "api/show/morning/task_words.h"
#include "api/show/report/time_text.h"
#include "api/show/windows/windows_answer.h"
#include "fields/base/encode/html.h"
#include "fields/base/text.h"
#include "twin/risk/workability/daylight.h"

namespace slackwater::api {
namespace {

/// Times of the day as shares of the picture's width.
class Across {
 public:
  explicit Across(const Morning& morning)
      : from_(morning.windows.from), span_(morning.windows.to - morning.windows.from) {}
  [[nodiscard]] double percent(UtcTime time) const { return 100 * share(time - from_); }
  [[nodiscard]] double percent(Duration duration) const { return 100 * share(duration); }

 private:
  [[nodiscard]] double share(Duration duration) const {
    return static_cast<double>(duration.count()) / static_cast<double>(span_.count());
  }
  UtcTime from_;
  Duration span_;
};

std::string box(const char* kind, double left, double width, double height) {
  return formatted("<i class=\"{}\" style=\"left:{:.2f}%;width:{:.2f}%;height:{:.0f}%\"></i>", kind,
                   left, width, height);
}

/// Where the sun is down, behind the columns.
std::string nights(const Morning& morning, const Across& across) {
  const WindowsAnswer& windows = morning.windows;
  const StepClock clock{
      windows.from, std::chrono::minutes(10),
      static_cast<std::size_t>((windows.to - windows.from) / std::chrono::minutes(10))};
  const twin::StepRanges light =
      twin::light_steps(clock, windows.water.surround.site, twin::Light::sun_up);
  std::string html;
  for (const twin::StepRange& night : twin::outside(light, clock.steps)) {
    const double left = across.percent(clock.time_of(night.begin));
    html += box("night", left, across.percent(clock.time_of(night.end)) - left, 100);
  }
  return html;
}

const char* kind_of(double probability, const twin::VerdictRule& rule) {
  switch (twin::verdict_of(probability, rule)) {
    case twin::Verdict::go:
      return "go";
    case twin::Verdict::marginal:
      return "marginal";
    default:
      return "low";
  }
}

std::string columns(const Morning& morning, const TaskWindows& task, const Across& across) {
  const double width = across.percent(morning.question.windows.every);
  std::string html;
  for (const TaskStart& start : task.starts) {
    if (!start.forbidden.empty()) continue;
    html += box(kind_of(start.worth, morning.question.windows.rule), across.percent(start.start),
                width, 100 * start.probability);
    if (start.twin) {
      // One flight is no chance of 0 or 100 %: how little it says is drawn as long as it is.
      const twin::SuccessInterval& interval = start.twin->interval;
      const double left = across.percent(start.start) + width / 2;
      html +=
          formatted("<i class=\"open\" style=\"left:{:.2f}%;bottom:{:.0f}%;height:{:.0f}%\"></i>",
                    left, 100 * interval.low, 100 * (interval.high - interval.low)) +
          formatted("<b class=\"flown\" style=\"left:{:.2f}%;bottom:{:.0f}%\"></b>", left,
                    100 * start.twin->probability);
    }
  }
  return html;
}

/// "06:00–09:30 90 to 98 %; 14:00 52 %": what the picture shows, for who cannot see it.
std::string picture_text(const Morning& morning, const TaskWindows& task) {
  const MorningClock clock(morning);
  std::string text;
  for (const WorthRun& run : runs_of_worth(task, morning.question.windows.rule.marginal, 2))
    text += (text.empty() ? "" : "; ") +
            clock(task.starts[run.first].start, task.starts[run.last].start) +
            formatted(" {:.0f} to {:.0f} %", 100 * run.least, 100 * run.most);
  return text.empty() ? "no start has a useful chance" : text;
}

std::string row(const Morning& morning, const TaskWindows& task, const Across& across,
                const std::string& behind, std::size_t most_words) {
  const std::string_view verdict = twin::name_of(task.verdict);
  std::string html = "<li><h3>" + escaped_html(task.name) +
                     "</h3><p class=\"verdict\" data-verdict=\"" + std::string(verdict) + "\">" +
                     escaped_html(verdict_and_unchecked(task)) + "</p><p class=\"where\">" +
                     escaped_html(where_and_how_long(task)) + "</p>";
  html += "<div class=\"track\" role=\"img\" aria-label=\"Chance by start: " +
          escaped_html(picture_text(morning, task)) + "\">" + behind +
          columns(morning, task, across) + "</div><div class=\"words\">";
  const std::vector<std::string> lines = task_words(morning, task);
  for (std::size_t i = 0; i < std::min(most_words, lines.size()); ++i)
    html += "<p>" + escaped_html(lines[i]) + "</p>";
  return html + "</div></li>\n";
}

/// The clock above the pictures: hours of a day, fewer of several.
std::string hours(const Morning& morning, const Across& across) {
  using std::chrono::hours;
  const Duration span = morning.windows.to - morning.windows.from;
  const auto every = span <= hours(24) ? hours(3) : span <= hours(72) ? hours(12) : hours(24);
  std::string html = "<div class=\"hours\" aria-hidden=\"true\">";
  UtcTime time = std::chrono::ceil<hours>(morning.windows.from);
  while ((time - UtcTime(day_of(time))) % every != Duration(0)) time += hours(1);
  for (; time <= morning.windows.to; time += every) {
    const bool is_end = time == morning.windows.to;
    const bool is_midnight = time == UtcTime(day_of(time)) && span > hours(24);
    html += formatted("<span class=\"{}\" style=\"left:{:.2f}%\">",
                      time == morning.windows.from ? "begin"
                      : is_end                     ? "end"
                                                   : "",
                      across.percent(time)) +
            (is_midnight                               ? date_text(time)
             : is_end && time == UtcTime(day_of(time)) ? std::string("24")
                                                       : format_utc(time).substr(11, 2)) +
            "</span>";
  }
  return html + "</div>";
}

/// Section and rows; the section is left open.
std::string picture(const Morning& morning, const std::string& id, std::size_t most_words) {
  const Across across(morning);
  const std::string behind = nights(morning, across);
  std::string html = "<section id=\"" + id + "\" class=\"gantt\"><h2>When each task can begin " +
                     escaped_html(MorningClock(morning).span()) + "</h2><div class=\"scale\">" +
                     hours(morning, across) + "</div><ol>\n";
  for (const TaskWindows* task : by_verdict(morning))
    html += row(morning, *task, across, behind, most_words);
  for (const TaskLeftOut& one : morning.windows.left_out)
    html += "<li><h3>" + escaped_html(one.task) +
            "</h3><p class=\"verdict\" data-verdict=\"unknown\">unknown</p><div "
            "class=\"words\"><p>It could not be worked "
            "out: " +
            escaped_html(one.why) + "</p></div></li>\n";
  return html + "</ol>";
}

}  // namespace

std::string gantt_html(const Morning& morning) {
  return picture(morning, "gantt", std::string::npos) + "<p class=\"note\">" +
         escaped_html(rules_text(morning)) + "</p></section>\n";
}

std::string gantt_today_html(const Morning& morning) {
  constexpr std::size_t few_words = 2;
  if (!morning.today) return {};
  return picture(today_of(morning), "gantt-today", few_words) + "</section>\n";
}

}  // namespace slackwater::api
