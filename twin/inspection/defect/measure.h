#pragma once
#include <cstdint>
#include <optional>
#include <string_view>

#include "twin/inspection/defect/defect_facts.h"
#include "twin/inspection/instrument/instrument.h"

namespace slackwater::twin {

/// What an instrument tells of a defect as a number.
enum class Quantity {
  scour_depth,       ///< m below the bed as it was
  burial_depth,      ///< m of cover over a cable
  wall_thickness,    ///< m of steel
  potential,         ///< mV against Ag/AgCl in sea water
  chain_diameter,    ///< m of bar
  growth_thickness,  ///< m
};
/// scour_depth, ...
[[nodiscard]] const char* name_of(Quantity quantity) noexcept;
[[nodiscard]] const char* unit_of(Quantity quantity) noexcept;  ///< m or mV

/// What an instrument of this kind measures of a defect of that kind; nothing where it only shows
/// that there is one.
[[nodiscard]] std::optional<Quantity> quantity_of(DefectKind defect,
                                                  InstrumentKind instrument) noexcept;

/// The true value at a defect of such a severity, in the quantity's unit.
[[nodiscard]] double value_of(Quantity quantity, double severity,
                              const DefectFacts& facts) noexcept;
/// The severity that such a value speaks of: the inverse, not below 0.
[[nodiscard]] double severity_of(Quantity quantity, double value,
                                 const DefectFacts& facts) noexcept;

/// One reading.
struct Reading {
  Quantity quantity{};
  double value = 0;  ///< in the quantity's unit
  double truth = 0;
};

/// Whose reading of what: the draws rest on these alone.
struct ReadingKey {
  std::uint64_t seed = 0;
  std::string_view instrument;  ///< of the run, one name each: its bias is one draw
  std::string_view place;       ///< of the reading: its noise is another
};

/// truth + bias + noise: the bias normal with the instrument's bias_sd and the same for all its
/// readings in a run, the noise normal with noise_sd + noise_per_range r. The instrument's unit is
/// turned into the quantity's.
/// @throws Error(invalid_input) where the units do not go together
[[nodiscard]] double measured(Quantity quantity, double truth, const Instrument& instrument,
                              double range_m, const ReadingKey& key);

/// What one of the instrument's unit is in the quantity's. @throws Error(invalid_input)
[[nodiscard]] double unit_factor(Quantity quantity, const Instrument& instrument);

}  // namespace slackwater::twin
