#include "calibration/day/part_failure.h"

#include <array>

namespace slackwater::calibration {
namespace {

struct PartWords {
  std::string_view name;
  std::string_view subject;  ///< "the waves"
  std::string_view loss;     ///< what the reader is without; follows "failed,"
};

constexpr std::array<PartWords, 15> words_of_parts{{
    {"day", "the choice of the day", "no current is forecast"},
    {"wind", "the wind", "the wind and the wind-driven current are left out"},
    {"waves", "the waves", "none are forecast"},
    {"wave_errors", "the comparison of past wave forecasts with what came",
     "heights and their band are not corrected by it"},
    {"record", "the record of currents", "no current is forecast"},
    {"mixed_layer", "the product's mixed layer", "it is not used"},
    {"tide", "the tide", "it is left out of the current"},
    {"calibration", "the calibration", "no current is forecast"},
    {"propagation", "the forecast from the calibrated day to the horizon",
     "no current is forecast"},
    {"column", "the forecast", "nothing is forecast"},
    {"rehearsal", "the rehearsal of past days",
     "our own forecast is issued without a blend, with its spread unchanged"},
    {"blend", "the blend", "our own forecast is issued without a blend"},
    {"unresolved_tide", "the tide that is averaged out of the means",
     "the band is not widened for it"},
    {"stand_in", "the comparison with the leading product", "the band is not widened for it"},
    {"sea_level", "the level of the sea", "none is forecast"},
}};

const PartWords& words_of(Part part) noexcept {
  return words_of_parts[static_cast<std::size_t>(part)];
}

}  // namespace

std::string_view name_of(Part part) noexcept { return words_of(part).name; }

bool loses_the_current(Part part) noexcept {
  return part == Part::record || part == Part::calibration || part == Part::propagation ||
         part == Part::column;
}

bool attempt_part(Part part, std::vector<PartFailure>& failures,
                  const std::function<void()>& work) {
  auto failure = attempt(work);
  if (!failure) return true;
  failures.push_back({part, std::move(*failure)});
  return false;
}

std::string failure_text(const PartFailure& first, std::size_t columns, std::size_t of_columns) {
  const PartWords& words = words_of(first.part);
  std::string text = std::string(words.subject) + " failed";
  const bool is_everywhere = columns >= of_columns;
  if (!is_everywhere)
    text += " at " + std::to_string(columns) + " of " + std::to_string(of_columns) + " columns";
  text += ", " + std::string(words.loss);
  if (!is_everywhere) text += " there";
  return text + ": " + first.failure.why;
}

}  // namespace slackwater::calibration
