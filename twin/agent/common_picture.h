#pragma once
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "twin/clearance/keep_clear.h"
#include "twin/environment/environment.h"
#include "twin/scenario/scenario.h"

namespace slackwater::twin {

struct Agent;
struct AgentState;

/// How a vehicle of a run keeps clear of what else is there. Shared by any threads.
struct Clearance {
  Handling handling;
  StandOff stand_off;
  std::vector<std::uint32_t> not_of_concern;  ///< whose tracks it follows
  bool only_structures = false;               ///< it looks at nothing that moves
};

/// The clearance of a vehicle: its handling by its autopilot, its upright cylinder by its length,
/// width and height; afloat from its keel to a mast of 0.3 of its length, an estimate.
[[nodiscard]] Clearance clearance_of(const Agent& agent, const StandOff& stand_off,
                                     const ScenarioVehicle& entry, double barrier_s);

/// What the vehicles of a run know of each other and of the traffic: as of the last barrier, so
/// that neither order nor threads make a difference. Those of one environment know each other;
/// futures that run beside each other do not. Nothing where nobody keeps clear.
///
/// Vehicles that do not keep clear are met as vessels that keep their course; so is the traffic
/// while it is heard. What a report leaves out is an estimate: a vessel of unknown length has 50 m,
/// its beam is 0.16 of the length, its draught 0.4 of the beam, its masts half of the length, at
/// most 60 m.
class CommonPicture {
 public:
  explicit CommonPicture(std::span<const Agent> agents);

  /// At a barrier, and at the start. No allocation.
  void publish(std::span<const Agent> agents, std::span<const AgentState> states, double t_s);
  /// What a vehicle that keeps clear looks at until the next barrier.
  [[nodiscard]] Lookout seen_by(const Agent& agent, std::size_t place) const noexcept;

 private:
  /// One environment and who is in it. Places count within it.
  struct World {
    const EnvironmentSampler* water = nullptr;
    std::vector<std::size_t> agents;
    std::vector<Handling> handling;  ///< of each, whether it keeps clear or not
    std::shared_ptr<const std::vector<TrafficVessel>> vessels;
    std::vector<Craft> craft;
    std::vector<std::array<Triple<double>, tether_nodes>> nodes;
    std::vector<Line> lines;
    std::vector<Passer> passers;
  };
  void publish_craft(std::span<const Agent> agents, std::span<const AgentState> states,
                     World& world);

  std::vector<World> worlds_;
  struct Place {
    std::size_t world = 0;
    std::size_t in_it = 0;
  };
  std::vector<Place> place_;  ///< of each vehicle of the run
};

/// The reference of a step that keeps clear. Where that is not the one that is wanted, the vehicle
/// is not on its way, and the watch for its headway begins anew.
[[nodiscard]] Reference cleared(const Agent& agent, const Lookout& around, const Measured& measured,
                                const Reference& wanted, AgentState& state) noexcept;

}  // namespace slackwater::twin
