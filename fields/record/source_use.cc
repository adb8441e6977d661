#include "fields/record/source_use.h"

#include <algorithm>

#include "fields/base/text.h"

namespace slackwater {
namespace {

std::string run_of(const Origin& origin) {
  if (origin.status != DataStatus::forecast) return std::string(name_of(origin.status));
  if (!origin.reference_time) return "forecast";
  return "forecast of " + format_utc(*origin.reference_time);
}

}  // namespace

std::vector<SourceUse> uses_of(const std::string& quantity, const std::vector<Stretch>& stretches,
                               UtcTime from, UtcTime to) {
  std::vector<SourceUse> uses;
  for (const Stretch& stretch : stretches) {
    if (stretch.to < from || stretch.from > to) continue;
    SourceUse use;
    use.quantity = quantity;
    use.product = stretch.origin->is_point_series ? "station " + stretch.origin->station
                                                  : stretch.origin->product_id;
    use.run = run_of(*stretch.origin);
    use.members = stretch.members;
    use.from_height_m = stretch.from_height_m;
    use.distance_m = stretch.distance_m;
    use.from = std::max(from, stretch.from);
    use.to = std::min(to, stretch.to);
    use.why = stretch.why;
    use.revised_times = stretch.revised_times;
    use.may_be_revised = stretch.may_be_revised;
    uses.push_back(std::move(use));
  }
  return uses;
}

std::string text_of(const SourceUse& use) {
  std::string text = use.quantity + ": " + use.product + ", " + use.run;
  if (use.members > 0) text += formatted(", mean of {} members", use.members);
  if (use.from_height_m) text += formatted(", brought to 10 m from {:g} m", *use.from_height_m);
  if (use.distance_m > 0) text += formatted(", {:.1f} km away", use.distance_m / 1000);
  text += ", " + format_utc(use.from) + " to " + format_utc(use.to) + ": " + use.why;
  if (use.revised_times > 0)
    text += formatted("; {} of its times came more than once", use.revised_times);
  if (use.may_be_revised) text += "; the values stored at the issue time are not known";
  return text;
}

}  // namespace slackwater
