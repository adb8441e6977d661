#include "twin/thruster/thrust_curve.h"

#include <span>

namespace slackwater::twin {
namespace {

std::size_t padded_half(const ThrustTable& table) { return table.half_count() + thrust_tries; }

std::size_t half_of(const ThrustTable& table, std::size_t row, bool is_astern) {
  return (2 * row + (is_astern ? 1 : 0)) * padded_half(table);
}

void split_in_halves(ThrustTable& table) {
  constexpr double huge_n = 1e300;
  table.half_n.assign(2 * table.voltage_v.count * padded_half(table), huge_n);
  for (std::size_t row = 0; row < table.voltage_v.count; ++row) {
    const double* none = table.thrust_n.data() + row * table.command.count + table.half_count() - 1;
    for (std::size_t step = 0; step < table.half_count(); ++step) {
      table.half_n[half_of(table, row, false) + step] = none[step];
      table.half_n[half_of(table, row, true) + step] = -*(none - step);
    }
  }
}

/// The last step with less than a share of the full thrust; with none, where the share is 0.
std::size_t last_with_less(std::span<const double> half_n, double share) {
  const double wanted_n = share * half_n.back();
  std::size_t step = 0;
  while (step + 2 < half_n.size() &&
         (share > 0 ? half_n[step + 1] < wanted_n : half_n[step + 1] <= 0))
    ++step;
  return step;
}

/// A row between two has, step by step, thrusts between theirs in proportion to its full one: what
/// is true of a share of the full thrust in both is true in it. So the step that is sought lies
/// between those of the two.
void index_half(ThrustTable& table, std::size_t row, bool is_astern) {
  const std::span all(table.half_n);
  const auto low = all.subspan(half_of(table, row, is_astern), table.half_count());
  const auto high = all.subspan(half_of(table, row + 1, is_astern), table.half_count());
  const auto share_at = [](std::size_t slot) {
    const double root = static_cast<double>(slot) / thrust_slots;
    return root * root;
  };
  for (std::size_t slot = 0; slot < thrust_slots; ++slot) {
    const double from = share_at(slot), to = share_at(slot + 1);
    const std::size_t least = std::min(last_with_less(low, from), last_with_less(high, from));
    const std::size_t most = std::max(last_with_less(low, to), last_with_less(high, to));
    table.least_step.push_back(static_cast<std::uint16_t>(least));
    table.tries = std::max(table.tries, most - least);
  }
}

}  // namespace

void index_thrusts(ThrustTable& table) {
  const std::size_t columns = table.command.count;
  table.step.clear();
  for (std::size_t i = 0; i < table.thrust_n.size(); ++i) {
    const std::size_t next = (i + 1) % columns > 0 ? i + 1 : i;  // nothing lies beyond the last
    table.step.insert(table.step.end(), {table.thrust_n[i], table.thrust_n[next], table.power_w[i],
                                         table.power_w[next]});
  }
  split_in_halves(table);
  table.least_step.clear();
  table.tries = 0;
  for (std::size_t row = 0; row + 1 < table.voltage_v.count; ++row) {
    index_half(table, row, false);
    index_half(table, row, true);
  }
}

ThrustCurve::ThrustCurve(const ThrustTable& table, double voltage_v)
    : command_step_(table.command.step), tries_(table.tries) {
  const PlaceOnAxis<double> place = place_on(table.voltage_v, voltage_v);
  const auto row = static_cast<std::size_t>(place.below);
  share_ = place.share;
  const double sag = speed_share(table.voltage_v.first, voltage_v);
  per_sag2_ = sag > 0 ? 1 / (sag * sag) : 0;
  ahead_ = way_of(table, row, false);
  astern_ = way_of(table, row, true);
}

ThrustCurve::Way ThrustCurve::way_of(const ThrustTable& table, std::size_t row,
                                     bool is_astern) const {
  Way way;
  way.low_n = table.half_n.data() + half_of(table, row, is_astern);
  way.high_n = table.half_n.data() + half_of(table, row + 1, is_astern);
  way.least_step = table.least_step.data() + (2 * row + (is_astern ? 1 : 0)) * thrust_slots;
  way.sign = is_astern ? -1 : 1;
  way.full_n = thrust_n(way, table.half_count() - 1);
  way.per_full_n = 1 / way.full_n;
  return way;
}

}  // namespace slackwater::twin
