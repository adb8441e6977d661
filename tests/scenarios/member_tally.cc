#include "tests/scenarios/member_tally.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "calibration/skill/predictive.h"
#include "tests/scenarios/ensemble_score.h"

namespace slackwater::tests {
namespace {

using calibration::Drawn;
using calibration::VariogramPair;

constexpr double normal_p90 = 1.2815515655446004;

bool is_known(Horizontal value) {
  return std::isfinite(value.real()) && std::isfinite(value.imag());
}

/// The values of a forecast at a stamp and level: its members, pairs together, and its centre.
struct Place {
  const Snapshot& snapshot;
  const ForecastColumn& column;

  [[nodiscard]] std::size_t size() const { return column.current_m_s.size(); }
  [[nodiscard]] std::size_t members() const { return column.member_m_s.size() / size(); }
  [[nodiscard]] std::size_t offset(std::size_t t, std::size_t k) const {
    return t * snapshot.depth_m.size() + k;
  }
  [[nodiscard]] bool has(std::size_t o) const { return has_value(column.current_status[o]); }
  [[nodiscard]] Horizontal departure(std::size_t m, std::size_t o) const {
    return column.member_m_s[m * size() + o] - column.current_m_s[o];
  }
};

double part(Horizontal value, int component) {
  return component == 0 ? value.real() : value.imag();
}

void add_component(const Place& at, std::size_t o, Horizontal truth, int component,
                   LeadDayTally& tally) {
  const double centre = part(at.column.current_m_s[o], component);
  const double sigma = at.column.current_sigma_m_s[o];
  const double y = part(truth, component);
  std::vector<double> x;
  for (std::size_t m = 0; m < at.members(); ++m)
    x.push_back(part(at.column.member_m_s[m * at.size() + o], component));
  const double crps =
      calibration::energy_score(x, std::vector<double>{y}, Drawn::in_opposite_pairs);
  x.push_back(centre);
  std::sort(x.begin(), x.end());
  const double below = calibration::probability_below(x, y);
  tally.n += 1;
  tally.held_normal += std::abs(y - centre) <= normal_p90 * sigma ? 1 : 0;
  tally.held_members += below >= 0.1 && below <= 0.9 ? 1 : 0;
  tally.crps_normal += calibration::score_of_normal(centre, sigma, y).crps;
  tally.crps_members += crps;
  tally.square += (y - centre) * (y - centre);
  tally.sigma_square += sigma * sigma;
}

void add(const Increments& more, Increments& sum) {
  sum.members += more.members;
  sum.truth += more.truth;
}
void add(const PathScores& more, PathScores& sum) {
  sum.energy += more.energy;
  sum.variogram_time += more.variogram_time;
  sum.variogram_depth += more.variogram_depth;
}

}  // namespace

double Increments::ratio() const { return std::sqrt(members / truth); }

void MemberTally::add(const Snapshot& snapshot, const ForecastColumn& column,
                      const TruthAt& truth) {
  add_values(snapshot, column, truth);
  add_increments(snapshot, column, truth);
  add_path(snapshot, column, truth);
}

void MemberTally::add_values(const Snapshot& snapshot, const ForecastColumn& column,
                             const TruthAt& truth) {
  const Place at{snapshot, column};
  const LeadDayTally before = lead_day.front();
  for (std::size_t t = 1; t < snapshot.time.size(); ++t) {
    const std::size_t day = std::min(lead_day.size() - 1, (t - 1) / 24);
    for (std::size_t k = 0; k < snapshot.depth_m.size(); ++k) {
      const std::size_t o = at.offset(t, k);
      const Horizontal y = truth(snapshot.time[t], k);
      if (!at.has(o) || !is_known(y)) continue;
      for (const int component : {0, 1}) add_component(at, o, y, component, lead_day[day]);
    }
  }
  const LeadDayTally& now = lead_day.front();
  if (now.n > before.n)
    daily_coverage.push_back((now.held_normal - before.held_normal) / (now.n - before.n));
}

void MemberTally::add_increments(const Snapshot& snapshot, const ForecastColumn& column,
                                 const TruthAt& truth) {
  const Place at{snapshot, column};
  const auto members = static_cast<double>(at.members());
  const auto add_pair = [&](std::size_t a, std::size_t b, Horizontal error_a, Horizontal error_b,
                            Increments& sum) {
    if (!at.has(a) || !at.has(b) || !is_known(error_a) || !is_known(error_b)) return;
    for (std::size_t m = 0; m < at.members(); ++m)
      sum.members += std::norm(at.departure(m, a) - at.departure(m, b)) / members;
    sum.truth += std::norm(error_a - error_b);
  };
  const std::size_t levels = snapshot.depth_m.size();
  std::vector<Horizontal> error(at.size());
  for (std::size_t t = 0; t < snapshot.time.size(); ++t) {
    for (std::size_t k = 0; k < levels; ++k)
      error[at.offset(t, k)] = truth(snapshot.time[t], k) - column.current_m_s[at.offset(t, k)];
  }
  // The first day alone: it is what the vehicles fly in.
  const std::size_t last = std::min<std::size_t>(24, snapshot.time.size() - 1);
  for (std::size_t t = 1; t <= last; ++t) {
    for (std::size_t k = 0; k < levels; ++k) {
      const std::size_t o = at.offset(t, k);
      for (std::size_t l = 0; l < lag_h.size(); ++l) {
        const std::size_t later = t + static_cast<std::size_t>(lag_h[l]);
        if (later > last) continue;
        const std::size_t p = at.offset(later, k);
        add_pair(o, p, error[o], error[p], in_time[l]);
      }
      for (std::size_t below = k + 1; below < levels; ++below) {
        const double apart = snapshot.depth_m[below] - snapshot.depth_m[k];
        const auto bin = static_cast<std::size_t>(
            std::lower_bound(layer_m.begin(), layer_m.end(), apart) - layer_m.begin());
        if (bin == layer_m.size()) continue;
        const std::size_t p = at.offset(t, below);
        add_pair(o, p, error[o], error[p], in_depth[bin]);
      }
    }
  }
}

void MemberTally::add_path(const Snapshot& snapshot, const ForecastColumn& column,
                           const TruthAt& truth) {
  const Place at{snapshot, column};
  const std::size_t levels = snapshot.depth_m.size();
  std::vector<std::size_t> stamps;
  for (std::size_t t = 1; t <= 24 && t < snapshot.time.size(); t += 3) stamps.push_back(t);
  std::vector<std::size_t> wet;
  for (std::size_t k = 0; k < levels; ++k) {
    const bool is_whole = std::all_of(stamps.begin(), stamps.end(), [&](std::size_t t) {
      return at.has(at.offset(t, k)) && is_known(truth(snapshot.time[t], k));
    });
    if (is_whole) wet.push_back(k);
  }
  if (wet.size() < 2) return;
  // Dimensions: stamps x levels x components.
  const auto dimension = [&](std::size_t s, std::size_t k, std::size_t c) {
    return (s * wet.size() + k) * 2 + c;
  };
  std::vector<VariogramPair> over_time;
  std::vector<VariogramPair> over_depth;
  for (std::size_t s = 0; s < stamps.size(); ++s) {
    for (std::size_t k = 0; k < wet.size(); ++k) {
      for (const std::size_t c : {0U, 1U}) {
        if (s + 1 < stamps.size())
          over_time.push_back({dimension(s, k, c), dimension(s + 1, k, c)});
        if (k + 1 < wet.size()) over_depth.push_back({dimension(s, k, c), dimension(s, k + 1, c)});
      }
    }
  }
  const auto order = [&](auto shuffled) {
    Rng random(1, "tests/dealt_anew");
    std::vector<std::size_t> which(at.members() * stamps.size() * wet.size());
    std::vector<std::size_t> deal(at.members());
    for (std::size_t s = 0; s < stamps.size(); ++s) {
      for (std::size_t k = 0; k < wet.size(); ++k) {
        if (shuffled(s, k)) {
          std::iota(deal.begin(), deal.end(), std::size_t{0});
          for (std::size_t i = deal.size() - 1; i > 0; --i)
            std::swap(deal[i], deal[random.bits() % (i + 1)]);
        }
        for (std::size_t m = 0; m < deal.size(); ++m)
          which[(m * stamps.size() + s) * wet.size() + k] = deal[m];
      }
    }
    return which;
  };
  const auto scored = [&](const std::vector<std::size_t>& which) {
    std::vector<double> members;
    for (std::size_t m = 0; m < at.members(); ++m) {
      for (std::size_t s = 0; s < stamps.size(); ++s) {
        for (std::size_t k = 0; k < wet.size(); ++k) {
          const std::size_t w = which[(m * stamps.size() + s) * wet.size() + k];
          const Horizontal x = column.member_m_s[w * at.size() + at.offset(stamps[s], wet[k])];
          members.push_back(x.real());
          members.push_back(x.imag());
        }
      }
    }
    std::vector<double> y;
    for (const std::size_t s : stamps) {
      for (const std::size_t k : wet) {
        const Horizontal value = truth(snapshot.time[s], k);
        y.push_back(value.real());
        y.push_back(value.imag());
      }
    }
    return PathScores{calibration::energy_score(members, y, Drawn::as_they_are),
                      calibration::variogram_score(members, y, over_time),
                      calibration::variogram_score(members, y, over_depth)};
  };
  const auto first = [](std::size_t s, std::size_t k) { return s == 0 && k == 0; };
  tests::add(scored(order(first)), as_drawn);
  tests::add(scored(order([](std::size_t, std::size_t k) { return k == 0; })), dealt_over_times);
  // One deal a level, the same at all times.
  std::vector<std::size_t> by_level = order([](std::size_t, std::size_t) { return true; });
  for (std::size_t m = 0; m < at.members(); ++m) {
    for (std::size_t s = 1; s < stamps.size(); ++s) {
      for (std::size_t k = 0; k < wet.size(); ++k)
        by_level[(m * stamps.size() + s) * wet.size() + k] =
            by_level[m * stamps.size() * wet.size() + k];
    }
  }
  tests::add(scored(by_level), dealt_over_levels);
  paths += 1;
}

void MemberTally::add(const MemberTally& other) {
  for (std::size_t d = 0; d < lead_day.size(); ++d) {
    LeadDayTally& sum = lead_day[d];
    const LeadDayTally& more = other.lead_day[d];
    sum.n += more.n;
    sum.held_normal += more.held_normal;
    sum.held_members += more.held_members;
    sum.crps_normal += more.crps_normal;
    sum.crps_members += more.crps_members;
    sum.square += more.square;
    sum.sigma_square += more.sigma_square;
  }
  daily_coverage.insert(daily_coverage.end(), other.daily_coverage.begin(),
                        other.daily_coverage.end());
  for (std::size_t l = 0; l < in_time.size(); ++l) tests::add(other.in_time[l], in_time[l]);
  for (std::size_t l = 0; l < in_depth.size(); ++l) tests::add(other.in_depth[l], in_depth[l]);
  tests::add(other.as_drawn, as_drawn);
  tests::add(other.dealt_over_times, dealt_over_times);
  tests::add(other.dealt_over_levels, dealt_over_levels);
  paths += other.paths;
}

void MemberTally::print(const std::string& name) const {
  std::printf("%s: %zu forecasts\n", name.c_str(), daily_coverage.size());
  for (std::size_t d = 0; d < lead_day.size(); ++d) {
    const LeadDayTally& t = lead_day[d];
    if (t.n <= 0) continue;
    std::printf(
        "  lead day %zu: 80 %% band holds %.1f %% (members %.1f %%), CRPS %.4f m/s (members "
        "%.4f), error %.4f, sigma %.4f a component\n",
        d + 1, 100 * t.coverage_normal(), 100 * t.coverage_members(), t.crps_normal / t.n,
        t.crps_members / t.n, std::sqrt(t.square / t.n), std::sqrt(t.sigma_square / t.n));
  }
  std::printf("  increments, members over truth:");
  for (std::size_t l = 0; l < in_time.size(); ++l)
    std::printf(" %d h %.2f", lag_h[l], in_time[l].ratio());
  for (std::size_t l = 0; l < in_depth.size(); ++l) {
    if (in_depth[l].truth > 0) std::printf(", <= %.0f m %.2f", layer_m[l], in_depth[l].ratio());
  }
  std::printf("\n");
  const auto line = [&](const char* what, const PathScores& s) {
    std::printf("  %-18s energy %.4f  variogram time %.4f  depth %.4f\n", what, s.energy / paths,
                s.variogram_time / paths, s.variogram_depth / paths);
  };
  line("as drawn", as_drawn);
  line("dealt over times", dealt_over_times);
  line("dealt over levels", dealt_over_levels);
}

}  // namespace slackwater::tests
