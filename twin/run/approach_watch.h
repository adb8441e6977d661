#pragma once
#include <array>
#include <span>
#include <vector>

#include "twin/agent/agent.h"

namespace slackwater::twin {

/// Notes in the states of a run's vehicles how near each came to what is around it
/// (`AgentState::nearest`): at the start, and along the straight ways from barrier to barrier.
///
/// Vehicles of one environment meet each other; futures that run beside each other do not, and
/// places count within one of them. A vehicle has passes while it goes and is not aboard; one that
/// has halted is there for the others. A vehicle and its carrier come as near as they like, its
/// line to its carrier too; nobody passes the vessel whose track it follows. Vessels of the traffic
/// are met where their track is known, whatever the depth. Lines lie still while a vehicle makes
/// its way from one barrier to the next.
///
/// An observer: it changes nothing of the run but that, keeps no more from one barrier to the next
/// than where everybody was, and leaves out what cannot have come nearer: those to the north and
/// south beyond the nearest pass so far, and structures until as much way is made.
class ApproachWatch {
 public:
  explicit ApproachWatch(std::span<const Agent> agents);

  /// They are where they are, without having gone there: at the start, or from a checkpoint.
  void begin(std::span<const AgentState> states, double t_s);
  /// One was put elsewhere between two barriers.
  void put(std::size_t agent, const AgentState& state) noexcept;
  /// At a barrier. No allocation.
  void look(std::span<const Agent> agents, std::span<AgentState> states, double t_s);

 private:
  /// The way of one since the last barrier.
  struct Going {
    Triple<double> from_m;
    Triple<double> to_m;
    double way_m = 0;
    double spare_m = 0;     ///< way that it makes before a structure can come nearer than one did
    bool is_out = false;    ///< there for others
    bool is_going = false;  ///< has passes of its own
  };
  struct Passing {
    Triple<double> from_m;
    Triple<double> to_m;
    std::uint32_t mmsi = 0;
    bool was_known = false;
    bool is_known = false;
  };
  struct Hanging {
    std::array<Triple<double>, tether_nodes> node_m;
    std::size_t owner = 0;  ///< by its place in the run
    std::size_t place = 0;
    Triple<double> low_m, high_m;  ///< of the box about it
  };
  /// One environment and who is in it.
  struct World {
    const EnvironmentSampler* water = nullptr;
    std::shared_ptr<const std::vector<TrafficVessel>> vessels;
    std::vector<std::size_t> agents;    ///< by their places in the run
    std::vector<std::size_t> by_north;  ///< places in this one, in that order
    std::vector<Passing> passing;
    std::vector<Hanging> lines;
    double most_way_m = 0;
  };
  struct Look {
    std::span<const Agent> agents;
    std::span<AgentState> states;
    double from_s = 0;
    double to_s = 0;
    [[nodiscard]] double at_s(double share) const { return from_s + share * (to_s - from_s); }
  };
  void move(const Look& look, World& world);
  void sort_by_north(World& world) const;
  void meet_vehicles(const Look& look, const World& world);
  void meet_one(const Look& look, const World& world, std::size_t place, std::size_t other_place);
  void meet_structures(const Look& look, std::size_t agent);
  void meet_vessels(const Look& look, const World& world);
  void meet_lines(const Look& look, World& world);

  std::vector<World> worlds_;
  std::vector<Going> going_;  ///< of each vehicle of the run
  std::vector<std::vector<std::uint32_t>> followed_;
  double from_s_ = 0;
};

}  // namespace slackwater::twin
