#include "twin/mission/wave_sector.h"

#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "fields/base/turn.h"

namespace slackwater::twin {
namespace {

using constants::degree;

bool is_in(const Range& range, double value) { return range.low <= value && value <= range.high; }

/// [low, high].
std::optional<Range> read_range(const Config& config, const char* key, Range range) {
  if (!config.has(key)) return std::nullopt;
  const std::vector<double> ends = config.numbers(key, range);
  if (ends.size() != 2 || !(ends[0] < ends[1]))
    config.refuse(key, formatted("expected two numbers, the lesser first, as in [{:g}, {:g}]",
                                 range.low, range.high));
  return Range{ends[0], ends[1]};
}

}  // namespace

bool WaveSector::holds(const SeaState& sea, double own_rad) const noexcept {
  if (peak_period_s && !std::isnan(sea.peak_period_s) && !is_in(*peak_period_s, sea.peak_period_s))
    return false;
  if (!off_bow_rad) return true;
  const double from_rad = sea.from_direction_deg * degree - heading_rad.value_or(own_rad);
  return std::isnan(from_rad) || is_in(*off_bow_rad, std::abs(short_way_rad(from_rad)));
}

std::optional<WaveSector> read_wave_sector(const Config& config) {
  WaveSector sector;
  if (const auto off_bow = read_range(config, "from_bow_deg", {0, 180}))
    sector.off_bow_rad = Range{off_bow->low * degree, off_bow->high * degree};
  sector.peak_period_s = read_range(config, "peak_period_between_s", {1, 30});
  if (const auto heading = config.optional_number("heading_deg", {-360, 360}))
    sector.heading_rad = *heading * degree;
  if (sector.heading_rad && !sector.off_bow_rad)
    config.refuse("heading_deg", "found without from_bow_deg, the sector about that bow; add it");
  if (!sector.off_bow_rad && !sector.peak_period_s) return std::nullopt;
  return sector;
}

std::string text_of(const WaveSector& sector) {
  std::string text;
  if (sector.off_bow_rad) {
    text = formatted("from {:.0f} to {:.0f} degrees off the bow", sector.off_bow_rad->low / degree,
                     sector.off_bow_rad->high / degree);
    if (sector.heading_rad) text += formatted(" (heading {:.0f})", *sector.heading_rad / degree);
  }
  if (sector.peak_period_s)
    text += (text.empty() ? "of " : ", ") + formatted("peak period {:g} to {:g} s",
                                                      sector.peak_period_s->low,
                                                      sector.peak_period_s->high);
  return text;
}

}  // namespace slackwater::twin
