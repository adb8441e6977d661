#pragma once
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "twin/helm/authority.h"
#include "twin/helm/refusal.h"
#include "twin/helm/run_authority.h"
#include "twin/run/newcomer_yard.h"
#include "twin/run/run.h"

namespace slackwater::twin {

/// How often commands of one source for one vehicle were refused for one reason.
struct RefusalCount {
  std::string source;
  std::string vehicle;  ///< its name, or what was given for one
  RefusalReason reason{};
  std::uint64_t count = 0;
  double last_s = 0;      ///< run time of the last one
  std::string last_text;  ///< the answer to that

  friend bool operator==(const RefusalCount&, const RefusalCount&) = default;
};

/// The one way into a run for all doors: checks a command, sees to it that one client alone is at
/// the helm of a vehicle, puts it into the run's queue or says why not. Thread-safe; a run that has
/// one keeps it alive until it is over.
///
/// Times are run time (`time_s()`), of which it hears at each barrier.
class CommandArbiter {
 public:
  /// Joins the run: looks at each opening and barrier. Between steps.
  explicit CommandArbiter(Run& run, const RefusalLimits& limits = {});
  CommandArbiter(const CommandArbiter&) = delete;
  CommandArbiter& operator=(const CommandArbiter&) = delete;

  /// Checks and enqueues for the next step (`command.step` 0) or a later one; in an opening of the
  /// run that is the step which begins. An empty `command.source` is set to the client.
  /// @param now_s  run time, see `time_s`; never falls
  /// @return nothing: it was taken; a vehicle takes `RefusalLimits::most_at_once` between two
  ///         openings, in a pause too
  [[nodiscard]] std::optional<Refusal> submit(std::string_view client, Command command,
                                              double now_s);

  /// Makes a vehicle ready that joins the run with the next step, for a client that may
  /// (`claim_run`). Nobody is at its helm, and it is known here (`vehicle`) from the barrier after
  /// that step on. Takes as long as files take.
  /// @return nothing: it comes
  [[nodiscard]] std::optional<Refusal> spawn(std::string_view client, const Newcomer& newcomer,
                                             const NewcomerYard& newcomer_yard, double now_s);

  /// Leads the weather of the run, for a client that may (`claim_run`), from the next step on.
  /// @return nothing: it comes
  [[nodiscard]] std::optional<Refusal> set_weather(std::string_view client,
                                                   const WeatherAsked& asked, double now_s);

  // Authority; see `Authority`. Each answers with nothing where it was done.
  [[nodiscard]] std::optional<Refusal> ask(std::string_view client, std::size_t vehicle,
                                           double now_s);
  /// A vehicle that goes by velocity, by thrusters or round and round a loop holds; a list of
  /// waypoints goes on to its last.
  [[nodiscard]] std::optional<Refusal> release(std::string_view client, std::size_t vehicle,
                                               double now_s);
  [[nodiscard]] std::optional<Refusal> allow_take_over(std::string_view client, std::size_t vehicle,
                                                       double now_s);

  // Of sessions of people, whose roles say who may. Each answers with nothing where it was done.

  /// The same as `ask`, on a lease: what the client tells the vehicle does not end it.
  [[nodiscard]] std::optional<Refusal> ask_for_lease(std::string_view client, std::size_t vehicle,
                                                     double now_s);
  /// It is leased to the client, whoever has it. What the vehicle was told stays in force.
  [[nodiscard]] std::optional<Refusal> take_over(std::string_view client, std::size_t vehicle,
                                                 double now_s);
  /// The client has the run, whoever had it.
  void take_over_run(std::string_view client, double now_s);
  /// Its holder cannot be heard: it holds, and later goes home (`HelmRule`). The helm stays its.
  void unheard(std::string_view client, std::size_t vehicle, double now_s);

  // Authority over the run itself; see `RunAuthority`. Each answers with nothing where it was done.
  [[nodiscard]] std::optional<Refusal> ask_for_run(std::string_view client, double now_s);
  [[nodiscard]] std::optional<Refusal> release_run(std::string_view client, double now_s);
  [[nodiscard]] std::optional<Refusal> allow_run_take_over(std::string_view client, double now_s);
  /// Whether the client may pause the run or step it now. See `RunAuthority::claim`.
  [[nodiscard]] std::optional<Refusal> claim_run(std::string_view client, double now_s);
  /// Empty: nobody.
  [[nodiscard]] std::string run_holder() const;

  /// The client is gone: what it held holds, and later goes home (`HelmRule`); the run is free.
  void lost(std::string_view client, double now_s);
  /// The same of one vehicle alone; what else the client holds it keeps.
  void lost(std::string_view client, std::size_t vehicle, double now_s);
  /// Empty: nobody.
  [[nodiscard]] std::string holder(std::size_t vehicle) const;
  /// The place of a vehicle in the run by its name; where there is none, `refuse_unknown` has the
  /// answer.
  [[nodiscard]] std::optional<std::size_t> vehicle(std::string_view name) const;

  /// How many commands of clients a vehicle has taken, the one submitted last included.
  [[nodiscard]] std::uint64_t taken(std::size_t vehicle) const;

  /// Whether what a vehicle was told last is in force only with a step that has not begun.
  [[nodiscard]] bool is_waiting(std::size_t vehicle) const;

  /// Of the last barrier.
  [[nodiscard]] double time_s() const;
  /// As of the last barrier: what is in force.
  [[nodiscard]] Standing standing(std::size_t vehicle) const;
  /// By source, vehicle and reason. Beyond `most_counts` of them, all others are counted under the
  /// source "others".
  [[nodiscard]] std::vector<RefusalCount> refusals() const;
  static constexpr std::size_t most_counts = 1000;
  /// Of a run that is taken up from a checkpoint.
  void restore(std::vector<RefusalCount> refusals);
  /// What a door refuses by itself, counted like any other. @param vehicle  what was given for one
  Refusal refuse(std::string_view client, std::string_view vehicle, Refusal refusal, double now_s);
  /// For doors that know vehicles by name. Counted like any other.
  [[nodiscard]] Refusal refuse_unknown(std::string_view client, std::string_view vehicle,
                                       double now_s);

 private:
  void open();
  void look(double time_s);
  void know_newcomers();
  [[nodiscard]] const Agent* agent(std::size_t vehicle) const;
  [[nodiscard]] std::optional<Refusal> look_at_name(const std::string& name) const;
  [[nodiscard]] std::optional<Refusal> refusal_to(std::string_view client, std::size_t vehicle,
                                                  double now_s) const;
  [[nodiscard]] std::optional<std::uint64_t> last_sequence(std::string_view client,
                                                           std::size_t vehicle) const;
  [[nodiscard]] Refusal count(std::string_view client, std::string vehicle, Refusal refusal,
                              double now_s);
  [[nodiscard]] std::optional<Refusal> counted_unknown(std::string_view client, std::size_t vehicle,
                                                       double now_s);
  template <typename Do>
  [[nodiscard]] std::optional<Refusal> with_vehicle(std::string_view client, std::size_t vehicle,
                                                    double now_s, const Do& act);
  /// "rov is held by X", of the first vehicle that another client commands; empty: none.
  [[nodiscard]] std::string other_at_helm(std::string_view client) const;
  template <typename Do>
  [[nodiscard]] std::optional<Refusal> with_run(std::string_view client, double now_s,
                                                const Do& act);
  void enqueue_hold(std::string_view client, std::size_t vehicle, double now_s);

  Run& run_;
  RefusalLimits limits_;
  mutable std::mutex mutex_;
  Authority authority_;
  RunAuthority run_authority_;
  /// Of the run; those that join are here from the barrier after their first step on.
  std::vector<const Agent*> agents_;
  std::vector<std::string> coming_;  ///< names of those that are on their way
  std::vector<Standing> standing_;
  /// What each vehicle has taken.
  struct Taken {
    std::uint64_t all = 0;
    std::uint64_t opening = 0;  ///< of the last one
    std::size_t at_once = 0;    ///< since that opening
    void note(std::uint64_t now) noexcept;
    /// What was accepted since the opening `now` has not taken effect yet.
    [[nodiscard]] bool is_waiting(std::uint64_t now) const noexcept {
      return at_once > 0 && opening == now;
    }
  };
  std::vector<Taken> taken_;
  std::map<std::pair<std::string, std::size_t>, std::uint64_t, std::less<>> last_sequence_;
  std::vector<RefusalCount> counts_;
  std::uint64_t openings_ = 0;
  double time_s_ = 0;
};

}  // namespace slackwater::twin
