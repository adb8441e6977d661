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
  std::string before, after;             ///< for the record
  std::string vehicle;
};

/// Does what people of a session ask of a run, where their role and helm allow it, and says why not
/// where they do not. Knows nothing of sockets. Not thread-safe; lives while the run does.
class RunDesk {
 public:
  explicit RunDesk(const api::RunInHand& hand);

  /// Whether there is such a thing to do.
  [[nodiscard]] static bool knows(std::string_view what) noexcept;
  /// @throws Error(invalid_input) for a message that cannot be read
  [[nodiscard]] Said handle(const Seat& seat, const StationSays& says, const Seats& seats,
                            const RunNow& run, Milliseconds now);

  /// While a supervisor is seated, the run is the supervisors'.
  void mind_run(bool has_supervisor);
  /// Vehicles that have joined the run.
  void open(std::span<const twin::Agent> agents);
  [[nodiscard]] const std::vector<const twin::Agent*>& agents() const noexcept { return agents_; }
  [[nodiscard]] Helms& helms() noexcept { return helms_; }
  [[nodiscard]] const Helms& helms() const noexcept { return helms_; }
  /// Who paused it last; empty: nobody of the session.
  [[nodiscard]] const std::string& paused_by() const noexcept { return paused_by_; }
  /// The last number of the seat's commands.
  [[nodiscard]] std::int64_t last_number(unsigned seat) const;
  void forget(unsigned seat) { numbers_.erase(seat); }

 private:
  using Do = Said (RunDesk::*)(const Seat&, const StationSays&, const Seats&, const RunNow&,
                               Milliseconds);
  struct Deed {
    std::string_view what;
    Role least;
    Do act;
  };
  static const std::vector<Deed>& deeds();
  [[nodiscard]] static const Deed* deed_of(std::string_view what) noexcept;

  [[nodiscard]] Said ask(const Seat&, const StationSays&, const Seats&, const RunNow&,
                         Milliseconds);
  [[nodiscard]] Said give_back(const Seat&, const StationSays&, const Seats&, const RunNow&,
                               Milliseconds);
  [[nodiscard]] Said allow(const Seat&, const StationSays&, const Seats&, const RunNow&,
                           Milliseconds);
  [[nodiscard]] Said grant(const Seat&, const StationSays&, const Seats&, const RunNow&,
                           Milliseconds);
  [[nodiscard]] Said deny(const Seat&, const StationSays&, const Seats&, const RunNow&,
                          Milliseconds);
  [[nodiscard]] Said take_back(const Seat&, const StationSays&, const Seats&, const RunNow&,
                               Milliseconds);
  [[nodiscard]] Said raw(const Seat&, const StationSays&, const Seats&, const RunNow&,
                         Milliseconds);
  [[nodiscard]] Said stick(const Seat&, const StationSays&, const Seats&, const RunNow&,
                           Milliseconds);
  [[nodiscard]] Said thrusters(const Seat&, const StationSays&, const Seats&, const RunNow&,
                               Milliseconds);
  [[nodiscard]] Said waypoints(const Seat&, const StationSays&, const Seats&, const RunNow&,
                               Milliseconds);
  [[nodiscard]] Said hold(const Seat&, const StationSays&, const Seats&, const RunNow&,
                          Milliseconds);
  [[nodiscard]] Said home(const Seat&, const StationSays&, const Seats&, const RunNow&,
                          Milliseconds);
  [[nodiscard]] Said resume(const Seat&, const StationSays&, const Seats&, const RunNow&,
                            Milliseconds);
  [[nodiscard]] Said pause(const Seat&, const StationSays&, const Seats&, const RunNow&,
                           Milliseconds);
  [[nodiscard]] Said go_on(const Seat&, const StationSays&, const Seats&, const RunNow&,
                           Milliseconds);
  [[nodiscard]] Said step(const Seat&, const StationSays&, const Seats&, const RunNow&,
                          Milliseconds);
  [[nodiscard]] Said spawn(const Seat&, const StationSays&, const Seats&, const RunNow&,
                           Milliseconds);

  /// The vehicle that a message is about; what it is about now.
  struct About {
    std::size_t vehicle = 0;
    const twin::Agent* agent = nullptr;
    const VehicleNow* now = nullptr;
  };
  [[nodiscard]] About about(const StationSays& says, const RunNow& run) const;
  [[nodiscard]] Said begun(const About& about) const;
  /// What speaks against the number and the time of a command.
  [[nodiscard]] std::optional<twin::Refusal> stale(const Seat& seat, const StationSays& says,
                                                   Milliseconds now, Milliseconds most_ahead);
  [[nodiscard]] std::optional<twin::Refusal> no_helm(const Seat& seat, std::size_t vehicle) const;
  void submit(const Seat& seat, std::size_t vehicle, twin::CommandWhat what, const RunNow& run,
              Milliseconds now, Said& said);
  [[nodiscard]] Said simple(const Seat& seat, const StationSays& says, const RunNow& run,
                            Milliseconds now, twin::CommandWhat what, bool needs_helm);

  api::RunInHand hand_;
  Helms helms_;
  std::vector<const twin::Agent*> agents_;
  std::map<unsigned, std::int64_t> numbers_;
  std::map<std::string, std::uint64_t> sequences_;  ///< by client
  std::string paused_by_;
  bool has_run_ = false;
};

}  // namespace slackwater::people
