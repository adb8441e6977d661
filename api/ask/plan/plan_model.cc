#include "api/ask/plan/plan_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "api/ask/plan/plan_rules.h"
#include "api/ask/plan/pools.h"

namespace slackwater::api {
namespace {

/// A column that takes something over slots [from, to).
struct Taking {
  std::size_t column = 0;
  std::size_t from = 0;
  std::size_t to = 0;
};

class ModelBuilder {
 public:
  explicit ModelBuilder(const PlanProblem& problem)
      : problem_(problem),
        kits_(kits_of(problem)),
        crews_(crew_pools(problem)),
        vehicles_(vehicle_pools(problem)) {}

  PlanModel build() {
    add_options();
    add_vehicle_options();
    add_jobs();
    add_aboard();
    add_crews();
    add_vehicles();
    add_vessels();
    add_shifts_of_others();
    for (std::size_t b = 0; b < problem_.batteries.size(); ++b) add_battery(b);
    add_chargers();
    return std::move(model_);
  }

 private:
  using Pair = std::pair<std::size_t, std::size_t>;

  const JobStart& start_of(std::size_t column) const {
    const PlanModel::Option& option = model_.options[column];
    return problem_.jobs[option.job].starts[option.start];
  }
  const PlanJob& job_of(std::size_t column) const {
    return problem_.jobs[model_.options[column].job];
  }
  /// @param after_min  that it is taken after the work
  Taking taking(std::size_t column, std::size_t option, Minute after_min) const {
    const JobStart& start = start_of(option);
    const Minute end = problem_.minute_of(start.slot) + start.hold_min + after_min;
    return {column, start.slot, problem_.slot_from(end)};
  }

  /// When it takes its vessel, until she could be elsewhere; what touches is one.
  std::vector<Taking> stays(std::size_t column, Minute way) const {
    std::vector<Taking> all;
    for (const VesselStay& stay : stays_of(problem_, job_of(column), start_of(column))) {
      const std::size_t from = problem_.slot_from(stay.from),
                        to = problem_.slot_from(stay.to + way);
      if (!all.empty() && from <= all.back().to)
        all.back().to = std::max(all.back().to, to);
      else
        all.push_back({column, from, to});
    }
    return all;
  }

  /// The vehicles that will do for each need of a job on a vessel; nothing where one is missing.
  std::vector<std::vector<std::size_t>> fitting(std::size_t job, std::size_t vessel) const {
    std::vector<std::vector<std::size_t>> fit;
    for (const auto& kinds : problem_.jobs[job].vehicles)
      fit.push_back(vehicles_of(problem_, vessel, kinds));
    return fit;
  }

  bool has_packs(std::size_t vehicle, const JobStart& start) const {
    const auto battery = problem_.vehicles[vehicle].battery;
    return !battery ||
           packs_for(problem_.batteries[*battery], start) <= problem_.batteries[*battery].count;
  }

  /// Whether each need can have a vehicle of its own.
  bool choose_vehicles(const std::vector<std::vector<std::size_t>>& fit, const JobStart& start,
                       std::vector<std::size_t>& chosen) const {
    if (chosen.size() == fit.size()) return true;
    for (const std::size_t k : fit[chosen.size()]) {
      if (!has_packs(k, start) || std::find(chosen.begin(), chosen.end(), k) != chosen.end())
        continue;
      chosen.push_back(k);
      if (choose_vehicles(fit, start, chosen)) return true;
      chosen.pop_back();
    }
    return false;
  }

  void add_options() {
    for (std::size_t j = 0; j < problem_.jobs.size(); ++j) {
      const PlanJob& job = problem_.jobs[j];
      for (std::size_t v = 0; v < problem_.vessels.size(); ++v) {
        const auto fit = fitting(j, v);
        for (std::size_t pool = 0; pool < crews_.size(); ++pool) {
          const std::size_t c = crews_[pool].front();
          const PlanCrew& crew = problem_.crews[c];
          if (crew.vessel.value_or(v) != v || !is_skilled(crew, job)) continue;
          for (std::size_t s = 0; s < job.starts.size(); ++s) {
            const JobStart& start = job.starts[s];
            std::vector<std::size_t> chosen;
            if (!has_chance(problem_, start) || !choose_vehicles(fit, start, chosen) ||
                !vessel_holds(problem_, problem_.vessels[v], job, start) ||
                !shift_holds(problem_, problem_.vessels[v], crew, job, start))
              continue;
            const std::size_t column =
                model_.linear.add({job.priority * start.probability, 0, 1, true});
            model_.options.push_back({j, s, v, c});
            of_job_[j].push_back(column);
            of_crew_[{pool, v}].push_back(column);
            of_place_[{v, job.place}].push_back(column);
            of_start_[{j, v, s}].push_back(column);
          }
        }
      }
    }
  }

  /// Each pool of vehicles that may serve gets its columns: those of the crews where it is the only
  /// one, else one of its own, the sum over the vehicles being the sum over the crews.
  void add_vehicle_options() {
    for (const auto& [where, columns] : of_start_) {
      const auto [j, v, s] = where;
      const auto fit = fitting(j, v);
      for (std::size_t need = 0; need < fit.size(); ++need) {
        std::vector<std::size_t> ones;
        for (std::size_t pool = 0; pool < vehicles_.size(); ++pool) {
          const std::size_t k = vehicles_[pool].front();
          if (has_packs(k, problem_.jobs[j].starts[s]) &&
              std::find(fit[need].begin(), fit[need].end(), k) != fit[need].end())
            ones.push_back(pool);
        }
        if (ones.size() == 1) {
          for (const std::size_t column : columns) {
            of_vehicle_[{ones.front(), v}].push_back({column, column});
            model_.vehicle_options.push_back({column, j, need, vehicles_[ones.front()].front()});
          }
          continue;
        }
        LinearTerms sum;
        for (const std::size_t column : columns) sum.push_back({column, 1});
        for (const std::size_t pool : ones) {
          const std::size_t column = model_.linear.add({0, 0, 1, true});
          model_.vehicle_options.push_back({column, j, need, vehicles_[pool].front()});
          sum.push_back({column, -1});
          of_vehicle_[{pool, v}].push_back({column, columns.front()});
        }
        model_.linear.equal(std::move(sum), 0);
      }
    }
  }

  void add_jobs() {
    for (const auto& [job, columns] : of_job_) add_sum_at_most(columns, 1);
  }

  void add_sum_at_most(const std::vector<std::size_t>& columns, double most) {
    LinearTerms terms;
    for (const std::size_t column : columns) terms.push_back({column, 1});
    model_.linear.at_most(std::move(terms), most);
  }

  /// At each instant at most one of them, or as many times `each` as a further column says. Only
  /// instants at which one begins: what goes on at others goes on at one of these.
  void add_cliques(const std::vector<Taking>& takings, std::optional<std::size_t> most,
                   double each = 1) {
    std::set<std::size_t> begins;
    for (const Taking& taking : takings) begins.insert(taking.from);
    for (const std::size_t slot : begins) {
      std::map<std::size_t, double> at_once;
      for (const Taking& taking : takings)
        if (taking.from <= slot && slot < taking.to) at_once[taking.column] += 1;
      if (at_once.size() < 2 && !most) continue;
      LinearTerms terms;
      for (const auto& [column, factor] : at_once) terms.push_back({column, factor});
      if (most) terms.push_back({*most, -each});
      model_.linear.at_most(std::move(terms), most ? 0 : 1);
    }
  }

  static double size_of(const Pool& pool) { return static_cast<double>(pool.size()); }

  void add_aboard() {
    std::map<std::size_t, LinearTerms> vessels_of_crew, crews_of_vessel;
    for (const auto& [pair, columns] : of_crew_) {
      const auto [pool, v] = pair;
      const std::size_t aboard = model_.linear.add({0, 0, size_of(crews_[pool]), true});
      crew_aboard_[pair] = aboard;
      vessels_of_crew[pool].push_back({aboard, 1});
      crews_of_vessel[v].push_back({aboard, 1});
      std::map<std::size_t, LinearTerms> by_job;
      for (const std::size_t column : columns)
        by_job[model_.options[column].job].push_back({column, 1});
      for (auto& [job, terms] : by_job) {
        terms.push_back({aboard, -1});
        model_.linear.at_most(std::move(terms), 0);
      }
    }
    for (auto& [pool, terms] : vessels_of_crew)
      model_.linear.at_most(std::move(terms), size_of(crews_[pool]));
    for (auto& [v, terms] : crews_of_vessel)
      model_.linear.at_most(std::move(terms), static_cast<double>(problem_.vessels[v].crews));
  }

  void add_crews() {
    for (const auto& [pair, columns] : of_crew_) {
      std::vector<Taking> takings;
      for (const std::size_t column : columns) takings.push_back(taking(column, column, 0));
      add_cliques(takings, crew_aboard_.at(pair));
    }
  }

  /// Those that share packs are aboard together, or not; others are counted.
  void add_vehicles() {
    std::map<Pair, std::size_t> aboard;
    std::map<std::size_t, LinearTerms> vessels_of;
    for (const auto& [pair, uses] : of_vehicle_) {
      const auto [pool, v] = pair;
      const PlanVehicle& vehicle = problem_.vehicles[vehicles_[pool].front()];
      const double count = size_of(vehicles_[pool]);
      // A name that no kit has for what is counted pool by pool.
      const std::size_t group =
          vehicle.battery ? kits_[vehicles_[pool].front()] : problem_.vehicles.size() + pool;
      if (!aboard.contains({group, v})) {
        const std::size_t column = model_.linear.add({0, 0, vehicle.battery ? 1 : count, true});
        aboard[{group, v}] = column;
        vessels_of[group].push_back({column, 1});
      }
      std::vector<Taking> takings;
      for (const auto& [column, option] : uses)
        takings.push_back(taking(column, option, vehicle.swap_min));
      add_cliques(takings, aboard[{group, v}], vehicle.battery ? count : 1);
    }
    for (auto& [group, terms] : vessels_of) {
      const std::size_t most =
          group < problem_.vehicles.size() ? 1 : vehicles_[group - problem_.vehicles.size()].size();
      model_.linear.at_most(std::move(terms), static_cast<double>(most));
    }
  }

  /// What takes a vessel at a place: its jobs, until the vessel could be elsewhere. Where several
  /// may go on side by side, a column that is as large as any of them.
  std::vector<Taking> takings_at(std::size_t v, std::size_t place, Minute way) {
    const std::vector<std::size_t>& columns = of_place_.at({v, place});
    std::map<std::size_t, std::vector<Taking>> by_job;
    for (const std::size_t column : columns)
      for (const Taking& stay : stays(column, way))
        by_job[model_.options[column].job].push_back(stay);
    if (by_job.size() == 1) return by_job.begin()->second;
    std::size_t first = problem_.slots;
    std::size_t last = 0;
    for (const auto& [job, takings] : by_job) {
      for (const Taking& one : takings) {
        first = std::min(first, one.from);
        last = std::max(last, one.to);
      }
    }
    std::vector<Taking> there;
    for (std::size_t slot = first; slot < last; ++slot) {
      const std::size_t is_there = model_.linear.add({0, 0, 1, false});
      there.push_back({is_there, slot, slot + 1});
      for (const auto& [job, takings] : by_job) {
        LinearTerms terms;
        for (const Taking& one : takings)
          if (one.from <= slot && slot < one.to) terms.push_back({one.column, 1});
        if (terms.empty()) continue;
        terms.push_back({is_there, -1});
        model_.linear.at_most(std::move(terms), 0);
      }
    }
    return there;
  }

  void add_vessels() {
    for (std::size_t v = 0; v < problem_.vessels.size(); ++v) {
      std::vector<std::size_t> places;
      for (const auto& [pair, columns] : of_place_)
        if (pair.first == v) places.push_back(pair.second);
      if (places.size() < 2) continue;
      const auto& way = problem_.vessels[v].way_min;
      // From each place the shortest way to any other: these bind all places at once.
      std::map<std::size_t, Minute> shortest;
      for (const std::size_t a : places) {
        for (const std::size_t b : places) {
          if (a == b) continue;
          const Minute here = std::min(way[a][b], shortest.contains(a) ? shortest[a] : way[a][b]);
          shortest[a] = here;
        }
      }
      std::map<std::size_t, std::vector<Taking>> at_least;
      std::vector<Taking> all;
      for (const std::size_t a : places) {
        at_least[a] = takings_at(v, a, shortest[a]);
        all.insert(all.end(), at_least[a].begin(), at_least[a].end());
      }
      add_cliques(all, std::nullopt);
      // Longer ways bind a place and those that are as far from it, where they take another slot.
      for (const std::size_t a : places) {
        std::set<Minute> ways;
        for (const std::size_t b : places)
          if (a != b) ways.insert(way[a][b]);
        Minute bound = shortest[a];
        for (const Minute longer : ways) {
          if (!takes_longer(v, a, longer, bound)) continue;
          bound = longer;
          const std::vector<Taking> here = takings_at(v, a, longer);
          std::vector<Taking> far = here;
          for (const std::size_t b : places)
            if (a != b && way[a][b] >= longer)
              far.insert(far.end(), at_least[b].begin(), at_least[b].end());
          add_cliques(far, std::nullopt);
        }
      }
    }
  }

  bool takes_longer(std::size_t v, std::size_t place, Minute way, Minute shortest) const {
    const std::vector<std::size_t>& columns = of_place_.at({v, place});
    return std::any_of(columns.begin(), columns.end(), [&](std::size_t column) {
      const std::vector<Taking> longer = stays(column, way), shorter = stays(column, shortest);
      return longer.size() != shorter.size() ||
             !std::equal(longer.begin(), longer.end(), shorter.begin(),
                         [](const Taking& a, const Taking& b) { return a.to == b.to; });
    });
  }

  /// A vessel keeps to the shifts of all who are aboard.
  void add_shifts_of_others() {
    for (const auto& [pair, aboard] : crew_aboard_) {
      const auto [pool, v] = pair;
      const PlanCrew& crew = problem_.crews[crews_[pool].front()];
      const double count = size_of(crews_[pool]);
      std::map<std::size_t, LinearTerms> beyond;
      for (const auto& [other, columns] : of_crew_) {
        if (other.second != v || other.first == pool) continue;
        for (const std::size_t column : columns) {
          if (!shift_holds(problem_, problem_.vessels[v], crew, job_of(column), start_of(column)))
            beyond[model_.options[column].job].push_back({column, count});
        }
      }
      for (auto& [job, terms] : beyond) {
        terms.push_back({aboard, 1});
        model_.linear.at_most(std::move(terms), count);
      }
    }
  }

  /// Charged and empty packs slot by slot, where they could run short.
  void add_battery(std::size_t b) {
    const PlanBattery& battery = problem_.batteries[b];
    std::vector<LinearTerms> taken(problem_.slots), back(problem_.slots);
    std::map<std::size_t, std::size_t> most_of_job;
    for (const auto& [pair, uses] : of_vehicle_) {
      if (problem_.vehicles[vehicles_[pair.first].front()].battery != b) continue;
      for (const auto& [column, option] : uses) {
        const std::size_t packs = packs_for(battery, start_of(option));
        const Taking used = taking(column, option, 0);
        taken[used.from].push_back({column, static_cast<double>(packs)});
        if (used.to < problem_.slots) back[used.to].push_back({column, static_cast<double>(packs)});
        std::size_t& most = most_of_job[model_.options[option].job];
        most = std::max(most, packs * problem_.jobs[model_.options[option].job].vehicles.size());
      }
    }
    std::size_t all = 0;
    for (const auto& [job, packs] : most_of_job) all += packs;
    if (all <= battery.count) return;
    const std::size_t lasts = charge_slots(problem_, battery);
    std::vector<LinearTerms> begun(problem_.slots), done(problem_.slots);
    for (std::size_t slot = 0; slot + lasts < problem_.slots; ++slot) {
      for (const std::size_t g : battery.chargers) {
        const auto places = static_cast<double>(problem_.chargers[g].places);
        const std::size_t column = model_.linear.add({0, 0, places, true});
        model_.charge_options.push_back({column, {b, g, slot}});
        begun[slot].push_back({column, 1});
        done[slot + lasts].push_back({column, 1});
        charging_[g].push_back({column, slot, slot + lasts});
      }
    }
    const auto count = static_cast<double>(battery.count);
    std::optional<std::size_t> charged_before, empty_before;
    for (std::size_t slot = 0; slot < problem_.slots; ++slot) {
      const std::size_t charged = model_.linear.add({0, 0, count, false});
      const std::size_t empty = model_.linear.add({0, 0, count, false});
      LinearTerms level{{charged, 1}}, rest{{empty, 1}};
      if (charged_before) level.push_back({*charged_before, -1});
      if (empty_before) rest.push_back({*empty_before, -1});
      append(level, taken[slot], 1);
      append(level, done[slot], -1);
      append(rest, back[slot], -1);
      append(rest, begun[slot], 1);
      model_.linear.equal(merged(level), charged_before ? 0 : count);
      model_.linear.equal(merged(rest), 0);
      charged_before = charged;
      empty_before = empty;
    }
  }

  static void append(LinearTerms& terms, const LinearTerms& more, double factor) {
    for (const LinearTerm& term : more) terms.push_back({term.column, factor * term.factor});
  }
  /// Each column once.
  static LinearTerms merged(const LinearTerms& terms) {
    std::map<std::size_t, double> sums;
    for (const LinearTerm& term : terms) sums[term.column] += term.factor;
    LinearTerms all;
    for (const auto& [column, factor] : sums) all.push_back({column, factor});
    return all;
  }

  void add_chargers() {
    for (const auto& [g, takings] : charging_) {
      for (std::size_t slot = 0; slot < problem_.slots; ++slot) {
        LinearTerms terms;
        for (const Taking& taking : takings)
          if (taking.from <= slot && slot < taking.to) terms.push_back({taking.column, 1});
        if (!terms.empty())
          model_.linear.at_most(std::move(terms), static_cast<double>(problem_.chargers[g].places));
      }
    }
  }

  const PlanProblem& problem_;
  std::vector<std::size_t> kits_;
  std::vector<Pool> crews_;
  std::vector<Pool> vehicles_;
  PlanModel model_;
  std::map<std::size_t, std::vector<std::size_t>> of_job_;
  std::map<Pair, std::vector<std::size_t>> of_crew_;                         ///< crew pool, vessel
  std::map<Pair, std::vector<std::size_t>> of_place_;                        ///< vessel, place
  std::map<std::array<std::size_t, 3>, std::vector<std::size_t>> of_start_;  ///< job, vessel, start
  std::map<Pair, std::vector<Pair>> of_vehicle_;  ///< vehicle pool, vessel: column, option
  std::map<Pair, std::size_t> crew_aboard_;
  std::map<std::size_t, std::vector<Taking>> charging_;
};

}  // namespace

PlanModel model_of(const PlanProblem& problem) { return ModelBuilder(problem).build(); }

PlanDraft draft_of(const PlanProblem& problem, const PlanModel& model,
                   std::span<const double> values) {
  PlanDraft draft;
  for (std::size_t i = 0; i < model.options.size(); ++i) {
    if (values[i] < 0.5) continue;
    const PlanModel::Option& option = model.options[i];
    Assignment one{option.job, option.start, option.vessel, option.crew, {}};
    for (const auto& kinds : problem.jobs[option.job].vehicles) {
      const std::vector<std::size_t> fit = vehicles_of(problem, option.vessel, kinds);
      one.vehicles.push_back(fit.empty() ? 0 : fit.front());
    }
    draft.assignments.push_back(std::move(one));
  }
  for (const PlanModel::VehicleOption& option : model.vehicle_options) {
    if (values[option.column] < 0.5) continue;
    for (Assignment& one : draft.assignments)
      if (one.job == option.job) one.vehicles[option.need] = option.vehicle;
  }
  for (const PlanModel::ChargeOption& option : model.charge_options)
    for (int n = static_cast<int>(std::lround(values[option.column])); n > 0; --n)
      draft.charges.push_back(option.charge);
  sort_by_time(problem, draft.assignments);
  share_out(problem, draft.assignments);
  return draft;
}

}  // namespace slackwater::api
