#pragma once
#include <span>
#include <vector>

#include "api/ask/plan/linear_model.h"
#include "api/ask/plan/plan.h"

namespace slackwater::api {

/// A day's plan as a linear model in 0s and 1s.
///
/// Columns: x(job, vessel, crew, start) = 1 where it is so done, worth priority x probability;
/// z(job, need, vessel, vehicle, start) where there is a choice of vehicles; how many of a pool of
/// crews or vehicles are aboard a vessel; the packs of a battery slot by slot. Crews and vehicles
/// that nothing tells apart are one pool: members are given out afterwards.
///
/// Rows are cliques in time, which bind tighter than pairs (Sousa and Wolsey 1992): of all that
/// takes a crew, a vehicle or a vessel at one instant, one. A vessel is taken until it can be
/// elsewhere; jobs at one place may share it, so there it is the place that takes it,
/// u(vessel, place, slot).
struct PlanModel {
  LinearModel linear;
  /// What the first columns stand for, without the vehicles.
  struct Option {
    std::size_t job = 0;
    std::size_t start = 0;
    std::size_t vessel = 0;
    std::size_t crew = 0;  ///< the first of its pool
  };
  std::vector<Option> options;  ///< of columns 0 to options.size() - 1
  struct VehicleOption {
    std::size_t column = 0;
    std::size_t job = 0;
    std::size_t need = 0;
    std::size_t vehicle = 0;  ///< the first of its pool
  };
  std::vector<VehicleOption> vehicle_options;
  struct ChargeOption {
    std::size_t column = 0;
    Charge charge;
  };
  std::vector<ChargeOption> charge_options;
};

/// @param problem  sound
[[nodiscard]] PlanModel model_of(const PlanProblem& problem);

/// What an answer says: assignments by time, and the charges that they need.
struct PlanDraft {
  std::vector<Assignment> assignments;
  std::vector<Charge> charges;
};
/// @param values  of all columns, whole but for rounding
[[nodiscard]] PlanDraft draft_of(const PlanProblem& problem, const PlanModel& model,
                                 std::span<const double> values);

}  // namespace slackwater::api
