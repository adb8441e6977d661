#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "fields/base/time.h"

namespace slackwater {

/// The product files that a forecast rests on.
struct ProductFiles {
  std::string product;
  std::vector<std::string> sha256;  ///< of each file, ascending
  bool operator==(const ProductFiles&) const = default;
};

/// The calibration that a forecast rests on: of the column that speaks for the site.
struct CalibrationSummary {
  std::string form;
  double rms_m_s = 0;       ///< misfit over the day
  std::string termination;  ///< how the search for the minimum ended
  std::map<std::string, double> parameters;
  bool operator==(const CalibrationSummary&) const = default;
};

/// What every number served from a forecast can name. Nothing is known of water that is made up.
struct Provenance {
  std::string site;
  std::optional<UtcTime> issued;
  std::vector<ProductFiles> inputs;  ///< by product
  std::string code_version;
  std::optional<CalibrationSummary> calibration;  ///< nothing: no current could be calibrated
  bool operator==(const Provenance&) const = default;
};

}  // namespace slackwater
