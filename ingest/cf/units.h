#pragma once
#include <string>
#include <string_view>

namespace slackwater::ingest {

/// canonical = scale * found + offset.
struct UnitConversion {
  double scale = 1.0;
  double offset = 0.0;
  [[nodiscard]] bool is_identity() const noexcept { return scale == 1.0 && offset == 0.0; }
};

/// How to turn values in the unit a file states into the canonical unit.
///
/// The frequent spellings ("m/s", "m s**-1", "Degree true", "meters") come from a small table, the
/// rest from UDUNITS-2. A pure number ("1") is not taken for an angle, though UDUNITS would. Throws
/// Error(invalid_input) naming `what`, the unit found and the unit expected where they do not
/// agree. Thread-safe.
[[nodiscard]] UnitConversion unit_conversion(std::string_view found, std::string_view canonical,
                                             std::string_view what);

}  // namespace slackwater::ingest
