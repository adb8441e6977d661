#include "twin/surface/cleaning_tool.h"

namespace slackwater::twin {

CleaningTool read_cleaning_tool(const Config& config) {
  CleaningTool tool;
  tool.swath_m = config.number("swath_m", {0.05, 5});
  tool.reach_m = config.number("reach_m", {0.1, 10});
  const auto removal = config.optional_number("removal_mm_m2_h", {1, 1e6});
  const auto rate = config.optional_number("rate_m2_h", {0.1, 1000});
  if (removal.has_value() == rate.has_value())
    config.refuse("removal_mm_m2_h",
                  "give one of removal_mm_m2_h, how much growth it takes off in an hour, and "
                  "rate_m2_h, how much face it lays bare");
  tool.removal_mm_m2_s = removal.value_or(0) / 3600;
  tool.rate_m2_s = rate.value_or(0) / 3600;
  tool.source = config.text("source");
  tool.status = config.text("status");
  return tool;
}

}  // namespace slackwater::twin
