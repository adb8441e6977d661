#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "api/ask/rehearse/advice.h"
#include "api/ask/rehearse/mission_file.h"
#include "api/ask/windows/alpha_practice.h"
#include "fields/base/local_time.h"
#include "twin/chance/success_interval.h"
#include "twin/risk/chance_calibration.h"
#include "twin/risk/past_verdicts.h"
#include "twin/risk/risk_register.h"
#include "twin/risk/start_chances.h"
#include "twin/risk/start_windows.h"
#include "twin/risk/workability/calendar.h"
#include "twin/risk/workability/daylight.h"
#include "twin/risk/workability/phase_plan.h"

namespace slackwater::api {

struct PastOutlooks;
struct VesselAccess;

/// Which windows are asked for.
struct WindowsQuestion {
  std::string site;                ///< id, or the path of its file
  std::optional<UtcDay> day;       ///< day D of the forecast; absent: the one in force
  std::filesystem::path forecast;  ///< a forecast's file instead; empty: of the store
  /// The water of that forecast where it is at hand; else it is read.
  std::optional<ScenarioWater> water;
  std::shared_ptr<const PastOutlooks> past;  ///< the mornings before it, where they are at hand
  std::vector<std::string> tasks;            ///< empty: those of the site
  std::vector<std::string> turbines;         ///< empty: the first that the task can be done at
  std::optional<UtcTime> from;               ///< of the starts; absent: the first full UTC day
  std::optional<UtcTime> to;                 ///< not itself a start
  Duration every = std::chrono::minutes(30);
  std::optional<Duration> contingency;  ///< absent: that of the task's sheet
  std::size_t members = 0;              ///< 0: as issued
  bool waves_as_forecast = false;       ///< in all members; else each has an error of its own
  bool chances_as_futures_say = false;  ///< past mornings change nothing of them
  bool is_over = false;  ///< it is asked about what came: when a vessel could leave is no question
  std::vector<twin::Assumption> assumed;
  std::optional<twin::Light> light;  ///< beside what the sheets say
  std::optional<twin::DayHours> shift;
  std::optional<TimeZone> zone;  ///< of the shift and of what people read; absent: UTC
  AlphaPractice practice;
  bool period_from_start = false;  ///< TPOP from the start, not from the issue
  twin::VerdictRule rule;
  bool may_leave_out = false;      ///< a task that cannot be worked out is told beside the others
  bool may_leave_all_out = false;  ///< even where there are no others
  int threads = 1;
};

/// What the twin says of a start: filled by a rehearsal.
struct TwinChance {
  /// Of success: the share that was done with the reserve kept and, where an inspection asks for
  /// something, saw it.
  double probability = 0;
  twin::SuccessInterval interval;     ///< 95 %, whenever the flights were stopped
  FlightCount p_done;                 ///< done alone
  std::optional<FlightCount> p_seen;  ///< seen alone; nothing: nothing is asked to be seen
  std::size_t flights = 0;
  std::vector<std::uint8_t> done;  ///< by member, 1 where it was a success
  std::string stopped_by;          ///< what stopped most, or was not seen; empty: nothing
  std::vector<double> duration_s;  ///< of those that were done
  std::vector<double> energy_wh;   ///< electrical, of all vehicles, by flight
  std::vector<twin::RiskEntry> risks;
};

/// One limit of a task.
struct TaskLimit {
  std::string worker;  ///< empty: of the task as a whole
  std::string text;
  std::optional<twin::Limit> limit;  ///< absent: hours that are open, or enough of them
};
/// "current at most 0.5 m/s (surveyor)".
[[nodiscard]] std::string text_of(const TaskLimit& limit);

struct TaskStart {
  UtcTime start;
  twin::StartChance chance;
  double by_futures = 0;   ///< that all limits hold to the way home, as they say (`next_success`)
  double probability = 0;  ///< the same with what past mornings make of it
  double worth = 0;        ///< to whoever decides: that, or what flights leave of it (worth.h)
  twin::SuccessInterval interval;               ///< 95 %, of what infinitely many futures would say
  std::optional<UtcTime> binds_at;              ///< of the binding limit
  std::optional<twin::HeightBound> bound_then;  ///< of it, where it has a table
  std::string forbidden;                        ///< why it may not be begun at all, whatever comes
  std::string unforecast;  ///< what nobody forecast of it (unforecast.h); empty: nothing
  double most_worth = 1;   ///< whatever the probability
  bool is_by_day = true;   ///< from 06:00 to 18:00 of people's clock, to its end
  std::optional<TwinChance> twin;
  std::string flights_stopped_by;  ///< what took from its worth; empty: nothing did
};

/// What the best start of a task would be worth if one of its limits did not count: what to look
/// for a vehicle, a method or an hour for that bears more of it.
struct Relief {
  std::size_t limit = 0;  ///< of the task
  UtcTime start;          ///< the best one then
  double probability = 0;
};

/// What flights of the best start, done otherwise, say.
struct FlownAdvice {
  UtcTime start;
  std::vector<Advice> changes;  ///< the greatest gain first, what is impossible last
};

struct WorkerPlan {
  std::string name;
  twin::PhasePlan plan;
};

/// The windows of one task.
struct TaskWindows {
  std::string id;
  std::string name;
  std::vector<std::string> turbines;
  std::vector<WorkerPlan> workers;
  double planned_s = 0;      ///< from the start to the way home of who works
  double contingency_s = 0;  ///< beyond it
  bool is_split = false;     ///< over several visits, each of this and more
  double least_visit_s = 0;
  std::vector<TaskLimit> limits;
  std::vector<std::string> not_checked;
  std::vector<std::string> assumed;
  std::vector<std::string> notes;
  /// In which the limits are held against the forecast: its members, or many more of its waves.
  std::size_t futures = 1;
  std::size_t independent = 1;          ///< as many as these tell of what infinitely many would say
  twin::ChanceCalibration calibration;  ///< what past mornings make of what the futures say
  twin::PastVerdicts past;              ///< what came of them
  twin::VerdictRule rule;               ///< of the question
  std::vector<TaskStart> starts;
  std::vector<twin::StartWindow> windows;                  ///< whose probability is worth a thought
  std::vector<twin::StartWindow> by_threshold;             ///< where the central forecast allows
  std::optional<std::vector<twin::StartWindow>> by_alpha;  ///< absent: practice says nothing
  std::string no_alpha;                                    ///< why
  twin::Verdict verdict = twin::Verdict::no_go;            ///< of the start that is worth most
  /// Of a task that is not a go by its limits: those that give its best start more, most first.
  std::vector<Relief> reliefs;
  std::optional<FlownAdvice> advice;  ///< of one that is not a go and whose flights fell short
};

/// A task that could not be worked out.
struct TaskLeftOut {
  std::string task;
  std::string why;
};

struct WindowsAnswer {
  std::string site_id;
  std::string site_name;
  ScenarioWater water;
  std::shared_ptr<const VesselAccess> vessel;  ///< whose ways and transfers are in every chance
  std::shared_ptr<const PastOutlooks> past;    ///< mornings that the chances are calibrated on
  UtcTime from;
  UtcTime to;
  std::vector<TaskWindows> tasks;
  std::vector<TaskLeftOut> left_out;  ///< where the question lets it
  twin::Verdict verdict =
      twin::Verdict::no_go;  ///< the worst of the tasks; no-go if one is left out
  std::vector<std::string> notes;
};

/// When each task can be begun, from the forecast in force: by the threshold rule, by practice, and
/// in which share of the members.
/// @throws Error(not_found) for sites, forecasts and tasks that there are not, Error(invalid_input)
///         for times outside the forecast, tasks that are longer than it or than the day, limits on
///         what nobody knows
[[nodiscard]] WindowsAnswer windows_of(const WindowsQuestion& question,
                                       const std::filesystem::path& store_folder);

}  // namespace slackwater::api
