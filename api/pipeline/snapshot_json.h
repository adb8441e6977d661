#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "fields/service/averaged_currents.h"
#include "fields/service/provenance.h"
#include "fields/site/chart_datum.h"

namespace slackwater::api {

// What a snapshot says of itself in every JSON of ours, with the keys of the attributes of a
// forecast's file (ingest/cf).

/// {"mean_h", "holds_part_of_the_tide", "unresolved_tide_m_s", "tidal_record"}; null of nothing.
[[nodiscard]] nlohmann::json averaged_json(const std::optional<AveragedCurrents>& averaged);

/// Without what is not known: {"site", "issued", "inputs", "code_version", "calibration"}.
[[nodiscard]] nlohmann::json provenance_json(const Provenance& provenance);

/// {"name", "below_mean_sea_level_m", "source"}; null of nothing.
[[nodiscard]] nlohmann::json chart_datum_json(const std::optional<ChartDatum>& datum);

}  // namespace slackwater::api
