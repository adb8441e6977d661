#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "twin/run/run_control.h"
#include "twin/run/step_pool.h"

namespace slackwater::twin {

/// The step that is being made.
struct StepTime {
  std::uint64_t step = 0;  ///< the first is 0
  double start_s = 0;      ///< since the epoch
  double length_s = 0;
  [[nodiscard]] double end_s() const noexcept { return static_cast<double>(step + 1) * length_s; }
};

/// A clock of fixed steps. In each, every client (physics, agents, observers) is called once, in an
/// order that is drawn anew from (run seed, step); after the last comes the barrier, where what
/// they wrote becomes what they read.
///
/// The order is drawn so that nobody comes to depend on it: a client reads what stood at the last
/// barrier and writes what is its own; with several threads they run beside each other. The order
/// of a step depends on nothing but seed and step, so that a run taken up from a checkpoint goes on
/// as it would have.
class Scheduler {
 public:
  using Client = std::function<void(const StepTime&)>;

  Scheduler(std::uint64_t run_seed, double step_s, std::size_t threads = 1);

  void add_client(Client client);
  /// Called before all clients of a step: where what came from outside takes effect.
  void before_step(Client opening) { openings_.push_back(std::move(opening)); }
  /// Called after all clients of a step, which then counts as made, in the order in which they were
  /// added.
  void at_barrier(Client barrier) { barriers_.push_back(std::move(barrier)); }

  /// The order of a step: a permutation of the clients. Fisher and Yates' shuffle.
  [[nodiscard]] std::vector<std::size_t> order_of(std::uint64_t step) const;
  /// Makes one step. No allocation of its own.
  void step();
  /// Steps until `steps` have been made in all, or the control says stop.
  /// @return the steps made in all
  std::uint64_t run(std::uint64_t steps, RunControl& control);

  [[nodiscard]] std::uint64_t steps_made() const noexcept { return made_; }
  /// Goes on from here: for a run that is taken up from a checkpoint.
  void resume_at(std::uint64_t step) noexcept { made_ = step; }
  [[nodiscard]] double step_s() const noexcept { return step_s_; }

 private:
  void draw_order(std::uint64_t step, std::vector<std::size_t>& order) const;

  std::uint64_t seed_;
  double step_s_;
  std::uint64_t made_ = 0;
  std::vector<Client> openings_;
  std::vector<Client> clients_;
  std::vector<Client> barriers_;
  StepTime now_;
  std::vector<std::size_t> order_;  ///< of the step that is being made
  std::function<void(std::size_t)> call_;
  StepPool pool_;
};

}  // namespace slackwater::twin
