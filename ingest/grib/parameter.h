#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "ingest/grib/message.h"

namespace slackwater::ingest::grib {

/// A weather-model quantity that we keep, as GRIB names it and as CF names it.
struct Parameter {
  long param_id;                   ///< ECMWF parameter database
  std::string_view short_name;     ///< as ecCodes and the operator say it
  std::string_view standard_name;  ///< CF
  std::string_view unit;           ///< canonical; GRIB codes it in the same unit
  /// Metres above the ground that the parameter itself means (10u: 10); 0: a surface quantity
  /// without height; negative: the message's own level says it.
  double height_m;
};

/// What a message holds, or nothing where we keep no such quantity or it stands on a level that is
/// no height above the ground (pressure and model levels).
struct Identified {
  const Parameter* parameter;
  std::optional<double>
      height_m;  ///< above the ground or sea surface; nothing for surface quantities (waves)
};
[[nodiscard]] std::optional<Identified> identify(const Message& message);

/// The parameter of a short name, e.g. "10u"; nothing for an unknown one.
[[nodiscard]] const Parameter* parameter_of(std::string_view short_name) noexcept;

/// The short names that we keep, for messages: "10u, 10v, ...".
[[nodiscard]] std::string known_parameters();

}  // namespace slackwater::ingest::grib
