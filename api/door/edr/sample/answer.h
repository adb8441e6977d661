#pragma once
#include <optional>
#include <string>
#include <vector>

#include "fields/base/time.h"

// What a query has found, before it takes the shape of a format. Queries fill it, formats write it;
// neither knows of the other.

namespace slackwater::api::edr {

/// A quantity that a collection offers.
struct Parameter {
  std::string name;           ///< its key, e.g. "eastward_sea_water_velocity_p10"
  std::string standard_name;  ///< CF; the id of the observed property
  std::string label;          ///< for people
  std::string description;
  std::string unit;        ///< UCUM symbol, "m/s"
  std::string unit_label;  ///< "metre per second"
  std::string method;      ///< "central", "quantile 0.1", "member 3"
  bool operator==(const Parameter&) const = default;
};

/// The CoverageJSON domain types that we serve.
enum class DomainType { point, point_series, vertical_profile, grid, trajectory };

/// What the vertical axis counts, metres from mean sea level.
enum class Vertical { none, depth_down, height_up };

/// Values over one domain. Axes are independent, and values run over t, z, y, x, the last fastest;
/// on a trajectory the axes have one entry a vertex each (the vertical one too, or one entry for
/// all, or none) and values one a vertex. NaN: no value.
struct Coverage {
  DomainType domain = DomainType::grid;
  std::string id;
  std::vector<double> longitude_deg;
  std::vector<double> latitude_deg;
  std::vector<double> vertical_m;  ///< empty where the quantity has no vertical
  std::vector<UtcTime> time;
  std::vector<std::vector<double>> values;  ///< per parameter of the answer
};

/// Of values that are a stored product's own: which they are.
struct ProductSource {
  std::string product_id;
  std::string dataset_id;            ///< empty: its files do not say
  std::vector<std::string> runs;     ///< "analysis", "forecast of 2024-06-11T00:00:00Z"
  std::vector<std::string> sources;  ///< sha256 of the product files
  /// Of what was measured: how far its place lies from the one that was asked about.
  std::optional<double> distance_m{};
};

/// Where an answer comes from; every format carries it.
struct Provenance {
  std::string site_id;
  std::string instance;  ///< id of the issued forecast
  UtcTime issued{};
  UtcDay day{};  ///< day D, the last calibrated
  std::string headline;
  bool degraded = false;
  std::vector<std::string> attributions;
  std::string code_version;
  /// Then there is no site, instance, issue, day or headline, and the code is what answers.
  std::optional<ProductSource> product{};
};

struct Answer {
  std::string collection;
  std::string title;
  Vertical vertical = Vertical::none;
  std::vector<Parameter> parameters;
  std::vector<Coverage> coverages;  ///< one or more, all of one domain type
  Provenance provenance;
  std::vector<std::string> notes;  ///< why values are missing, and the like
  std::string query_url;           ///< the end point that was asked
  struct Link {
    std::string rel;
    std::string type;
    std::string href;
  };
  std::vector<Link> links;  ///< for the formats that have a place for them
};

}  // namespace slackwater::api::edr
