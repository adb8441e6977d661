#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "api/ask/run/scenario_run.h"
#include "api/door/people/action.h"
#include "api/door/people/helms.h"
#include "api/door/people/station_says.h"
#include "api/door/people/vehicle_now.h"

namespace slackwater::people {

/// What became of a message.
struct Said {
  std::optional<twin::Refusal> refused;  ///< nothing: it was taken
  std::optional<std::uint64_t> step;     ///< of the run, before which it takes effect at the latest
  std::vector<std::string> shaped;       ///< by what of the vehicle's conduct
  bool is_on_record = true;              ///< else it is one of many (sticks), or nothing happened
  std::string before, after, why;        ///< for the record
  std::string vehicle;
};

/// What was not taken, and changed nothing.
[[nodiscard]] Said refused(twin::RefusalReason reason, std::string text);

/// From the origin: places farther off are taken for mistakes.
inline constexpr double farthest_m = 1e6;

/// `east_m`, `north_m`, `up_m` of an object, as NED. @throws Error(invalid_input)
[[nodiscard]] twin::Triple<double> place_of(const StationSays& says);

/// What a seat asks, and what there is to see as it does.
struct Asked {
  const Seat& seat;
  const StationSays& says;
  const Seats& seats;
  const RunNow& run;
  Milliseconds now = 0;
};

/// Does what people of a session ask of a run, where their role and helm allow it, and says why not
/// where they do not. Knows nothing of sockets. Not thread-safe; lives while the run does.
class RunDesk {
 public:
  explicit RunDesk(const api::RunInHand& hand);

  /// @throws Error(invalid_input) for a message that cannot be read
  [[nodiscard]] Said handle(const Asked& asked);

  /// While a supervisor is seated, the run is the supervisors'.
  void mind_run(bool has_supervisor);
  /// Vehicles that have joined the run.
  void open(std::span<const twin::Agent> agents);
  [[nodiscard]] const std::vector<const twin::Agent*>& agents() const noexcept { return agents_; }
  [[nodiscard]] Helms& helms() noexcept { return helms_; }
  [[nodiscard]] const Helms& helms() const noexcept { return helms_; }
  /// Who paused it last; empty: nobody of the session.
  [[nodiscard]] const std::string& paused_by() const noexcept { return paused_by_; }
  /// Who leads the weather; empty: nobody.
  [[nodiscard]] const std::string& weather_by() const noexcept { return weather_by_; }
  /// The last number of the seat's commands.
  [[nodiscard]] std::int64_t last_number(unsigned seat) const;
  void forget(unsigned seat) { counts_.erase(seat); }

 private:
  using Do = Said (RunDesk::*)(const Asked&);
  struct Deed {
    std::string_view what;
    Role least;
    Do act;
  };
  static const std::vector<Deed>& deeds();
  [[nodiscard]] static const Deed* deed_of(std::string_view what) noexcept;

  [[nodiscard]] Said ask(const Asked& asked);
  [[nodiscard]] Said give_back(const Asked& asked);
  [[nodiscard]] Said allow(const Asked& asked);
  [[nodiscard]] Said grant(const Asked& asked);
  [[nodiscard]] Said deny(const Asked& asked);
  [[nodiscard]] Said take_back(const Asked& asked);
  [[nodiscard]] Said raw(const Asked& asked);
  [[nodiscard]] Said stick(const Asked& asked);
  [[nodiscard]] Said thrusters(const Asked& asked);
  [[nodiscard]] Said waypoints(const Asked& asked);
  [[nodiscard]] Said hold(const Asked& asked);
  [[nodiscard]] Said home(const Asked& asked);
  [[nodiscard]] Said resume(const Asked& asked);
  [[nodiscard]] Said pause(const Asked& asked);
  [[nodiscard]] Said go_on(const Asked& asked);
  [[nodiscard]] Said step(const Asked& asked);
  [[nodiscard]] Said spawn(const Asked& asked);
  [[nodiscard]] Said camera(const Asked& asked);
  [[nodiscard]] Said weather(const Asked& asked);

  /// The vehicle that a message is about; what it is about now.
  struct About {
    std::size_t vehicle = 0;
    const twin::Agent* agent = nullptr;
    const VehicleNow* now = nullptr;
  };
  [[nodiscard]] About about(const Asked& asked) const;
  [[nodiscard]] Said begun(const About& about) const;
  /// Of a helm, without a command to its vehicle. @param act  (vehicle) -> what speaks against it
  template <typename Act>
  [[nodiscard]] Said of_helm(const Asked& asked, const Act& act);
  /// What speaks against the number and the time of a command.
  [[nodiscard]] std::optional<twin::Refusal> stale(const Asked& asked, Milliseconds most_ahead);
  [[nodiscard]] std::optional<twin::Refusal> no_helm(const Asked& asked, std::size_t vehicle) const;
  [[nodiscard]] std::optional<twin::Refusal> no_say(const Asked& asked, std::size_t vehicle);
  void submit(const Asked& asked, std::size_t vehicle, twin::CommandWhat what, Said& said);
  /// A command that is but a word.
  [[nodiscard]] Said order(const Asked& asked, twin::CommandWhat what, bool needs_helm);

  api::RunInHand hand_;
  Helms helms_;
  std::vector<const twin::Agent*> agents_;
  /// Of each seat.
  struct Counts {
    std::int64_t number = 0;     ///< the station's own, of its last command
    std::uint64_t sequence = 0;  ///< ours, for the arbiter
  };
  std::map<unsigned, Counts> counts_;
  std::string paused_by_, weather_by_;
  bool has_run_ = false;
};

}  // namespace slackwater::people
