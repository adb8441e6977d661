#include "api/ask/plan/pools.h"

#include <algorithm>
#include <map>

#include "fields/base/check.h"

namespace slackwater::api {
namespace {

template <typename Things, typename IsSame>
std::vector<Pool> pools_of(const Things& things, IsSame is_same) {
  std::vector<Pool> pools;
  for (std::size_t i = 0; i < things.size(); ++i) {
    const auto pool = std::find_if(pools.begin(), pools.end(), [&](const Pool& known) {
      return is_same(things[known.front()], things[i]);
    });
    if (pool == pools.end())
      pools.push_back({i});
    else
      pool->push_back(i);
  }
  return pools;
}

/// The members of some pools, as they are taken one after the other.
class Members {
 public:
  explicit Members(std::vector<Pool> pools) : pools_(std::move(pools)), used_(pools_.size()) {}

  /// A member of the pool of `any` that is free on a vessel from a minute on.
  std::size_t take(std::size_t any, std::size_t vessel, Minute from, Minute to) {
    const std::size_t pool = pool_of(any);
    std::vector<Taken>& aboard = aboard_[{pool, vessel}];
    const auto free = std::find_if(aboard.begin(), aboard.end(),
                                   [&](const Taken& one) { return one.until <= from; });
    if (free != aboard.end()) {
      free->until = to;
      return free->member;
    }
    expects(used_[pool] < pools_[pool].size(), "a pool has as many as are taken from it");
    aboard.push_back({pools_[pool][used_[pool]++], to});
    return aboard.back().member;
  }

 private:
  struct Taken {
    std::size_t member = 0;
    Minute until = 0;
  };
  std::size_t pool_of(std::size_t any) const {
    const auto pool = std::find_if(pools_.begin(), pools_.end(), [&](const Pool& one) {
      return std::find(one.begin(), one.end(), any) != one.end();
    });
    return static_cast<std::size_t>(pool - pools_.begin());
  }

  std::vector<Pool> pools_;
  std::vector<std::size_t> used_;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Taken>> aboard_;
};

}  // namespace

std::vector<Pool> crew_pools(const PlanProblem& problem) {
  return pools_of(problem.crews, [](const PlanCrew& a, const PlanCrew& b) {
    return a.skills == b.skills && a.shift == b.shift && a.vessel == b.vessel;
  });
}

std::vector<Pool> vehicle_pools(const PlanProblem& problem) {
  return pools_of(problem.vehicles, [](const PlanVehicle& a, const PlanVehicle& b) {
    return a.kind == b.kind && a.vessel == b.vessel && a.battery == b.battery &&
           a.swap_min == b.swap_min;
  });
}

void share_out(const PlanProblem& problem, std::span<Assignment> assignments) {
  Members crews(crew_pools(problem));
  Members vehicles(vehicle_pools(problem));
  for (Assignment& one : assignments) {
    const Minute begin = begin_of(problem, one), end = end_of(problem, one);
    one.crew = crews.take(one.crew, one.vessel, begin, end);
    for (std::size_t& k : one.vehicles)
      k = vehicles.take(k, one.vessel, begin, end + problem.vehicles[k].swap_min);
  }
}

}  // namespace slackwater::api
