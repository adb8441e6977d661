#pragma once
#include <optional>
#include <string>

#include "ingest/grib/message.h"

namespace slackwater::ingest::grib {

/// What a field is beside its quantity: a statistic over the members of an ensemble or over an
/// interval may carry the very name, unit and level of the wind itself.
struct Statistic {
  bool is_ensemble_mean = false;  ///< the mean over all members
  /// Why the field is not the quantity, in words: "spread of all members (template 4.2, derived
  /// forecast 4)"; empty where it is the quantity, or a mean of it.
  std::string refused;
  /// The member of an ensemble where only a local section says it (NCEP in GRIB 1); 0: the control.
  std::optional<int> member{};
};

/// What a message says of itself. Accepted are analyses, forecasts, members, and means over all
/// members, as instants or averages over time; all else is refused by name: spread and deviation,
/// percentile, probability, extremes over members or over time, accumulations, means of a cluster,
/// errors, climatology, and product templates that are not known here.
///
/// A gust is the maximum over an interval by its nature, so `is_gust` lets "maximum" pass.
///
/// Source: WMO Manual on Codes, FM 92 GRIB, code tables 1.4, 4.0, 4.3, 4.7, 4.10, 4.15; GRIB 1 code
/// table 5; ECMWF MARS types (codes.ecmwf.int/grib/format/mars/type); NCEP Office Note 388,
/// ensemble extension of the product definition section, octets 42 to 47.
[[nodiscard]] Statistic statistic_of(const Message& message, bool is_gust);

}  // namespace slackwater::ingest::grib
