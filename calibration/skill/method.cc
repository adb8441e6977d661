#include "calibration/skill/method.h"

#include <algorithm>

namespace slackwater::calibration {
namespace {

constexpr std::array<std::string_view, all_methods.size()> names{
    "day-mean", "forecast",       "merged",    "oracle-mean",   "persistence",
    "provider", "reference-slab", "same-hour", "tide-harmonic", "tide-phase"};
static_assert(std::is_sorted(names.begin(), names.end()),
              "methods stand in the order of their names");

}  // namespace

std::string_view name_of(Method method) noexcept { return names[static_cast<std::size_t>(method)]; }

}  // namespace slackwater::calibration
