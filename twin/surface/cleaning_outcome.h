#pragma once
#include <vector>

#include "twin/surface/cleaning.h"

namespace slackwater::twin {

/// How it went, over all patches.
struct CleaningOutcome {
  struct Band {
    double top_m = 0;  ///< z
    double bottom_m = 0;
    double area_m2 = 0;
    double cleaned_m2 = 0;
    double removed_m3 = 0;
    double left_m3 = 0;
    friend bool operator==(const Band&, const Band&) = default;
  };
  double area_m2 = 0;  ///< with growth to take off
  double cleaned_m2 = 0;
  double removed_m3 = 0;
  double left_m3 = 0;
  double density_kg_m3 = 0;  ///< 0: nobody says
  double done_at = 0;
  double worked_s = 0;
  std::size_t passes_needed = 1;
  std::vector<Band> bands;  ///< from the top down

  [[nodiscard]] double share() const noexcept { return cleaned_m2 / area_m2; }
  [[nodiscard]] bool is_done() const noexcept { return share() >= done_at; }
  friend bool operator==(const CleaningOutcome&, const CleaningOutcome&) = default;
};
[[nodiscard]] CleaningOutcome cleaning_outcome(const Cleaning& cleaning,
                                               const CleaningState& state);

}  // namespace slackwater::twin
