#include "ingest/insitu/series.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "ingest/cf/attribution.h"
#include "ingest/cf/granule_file.h"
#include "ingest/cf/settle.h"
#include "ingest/copernicus/product_catalogue.h"
#include "ingest/decoded/staged_files.h"
#include "ingest/insitu/series_checks.h"
#include "ingest/insitu/series_granule.h"
#include "ingest/insitu/station.h"
#include "ingest/insitu/station_reader.h"

namespace slackwater::ingest {
namespace {

const netcdf::Variable* spectrum_in(const netcdf::File& file) {
  for (const netcdf::Variable& variable : file.variables()) {
    const std::string name = variable.text("standard_name").value_or("");
    const bool over_frequency =
        std::any_of(variable.dimensions.begin(), variable.dimensions.end(),
                    [](const std::string& d) { return lower_case(d).starts_with("freq"); });
    if (over_frequency && (name == "spectral_wave_density" ||
                           contains_ignoring_case(name, "variance_spectral_density") ||
                           contains_ignoring_case(name, "variance_density"))) {
      return &variable;
    }
  }
  return nullptr;
}

bool says_series(const netcdf::File& file) {
  for (const char* attribute :
       {"featureType", "CF:featureType", "cdm_data_type", "data_type", "CF_featureType"}) {
    std::string text = lower_case(file.text(attribute).value_or(""));
    std::erase_if(text, [](char c) { return c == '-' || c == '_' || c == ' '; });
    if (text.find("timeseries") != std::string::npos || text == "station") return true;
  }
  return false;
}

/// Whether any variable lies on a grid of latitude and longitude.
bool is_gridded(const netcdf::File& file) {
  const auto dimension_of = [&](const char* standard_name,
                                std::initializer_list<std::string_view> names) {
    for (const netcdf::Variable& variable : file.variables()) {
      const std::string lower = lower_case(variable.name);
      const bool is_it = variable.text("standard_name") == standard_name ||
                         std::find(names.begin(), names.end(), lower) != names.end();
      if (is_it && variable.dimensions.size() == 1) return variable.dimensions[0];
    }
    return std::string();
  };
  const std::string rows = dimension_of("latitude", {"latitude", "lat"});
  const std::string columns = dimension_of("longitude", {"longitude", "lon"});
  if (rows.empty() || columns.empty() || rows == columns) return false;
  return std::any_of(
      file.variables().begin(), file.variables().end(), [&](const netcdf::Variable& variable) {
        const auto has = [&](const std::string& name) {
          return std::find(variable.dimensions.begin(), variable.dimensions.end(), name) !=
                 variable.dimensions.end();
        };
        return has(rows) && has(columns);
      });
}

void apply_status(Granule& granule, const IngestOptions& options) {
  granule.status = options.as.value_or(DataStatus::observation);
  if (granule.status == DataStatus::forecast) {
    if (!options.issued)
      throw Error(ErrorKind::usage, "--as forecast of a point series needs --issued TIME");
    granule.reference_time = options.issued;
  }
}

void write_granule(const std::filesystem::path& content_file, const Granule& granule,
                   SeriesGroup& group) {
  GranuleWriter writer(content_file, granule);
  for (std::size_t v = 0; v < group.series.size(); ++v) {
    SeriesValues& series = group.series[v];
    for (std::size_t i = 0; i < series.values.size(); ++i) {
      if (!has_value(series.status[i])) series.values[i] = std::numeric_limits<float>::quiet_NaN();
    }
    writer.put(v, 0, series.times, 0, 1, series.values);
    writer.put_status(v, 0, series.times, series.status);
  }
  writer.finish();
}

/// Decodes what runs along one of the file's time axes.
class SeriesDecoder {
 public:
  SeriesDecoder(const netcdf::File& file, const ProductCatalogue& products, const Product& product,
                const IngestOptions& options, const std::filesystem::path& staging_folder,
                Ingested& ingested)
      : file_(file),
        products_(products),
        product_(product),
        options_(options),
        staging_folder_(staging_folder),
        ingested_(ingested),
        water_depth_m_(water_depth_of(file)) {}

  void decode(const StationAxes& axes, const std::vector<Wanted>& wanted) {
    const SeriesTimes times = series_times_of(file_, axes, ingested_.warnings);
    for (std::size_t station = 0; station < axes.stations; ++station) {
      const GeoPoint position = position_of(file_, axes, station, ingested_.warnings);
      if (options_.cut && !options_.cut->contains(position)) {
        ++outside_;
        continue;
      }
      const auto placed =
          read_station(file_, axes, products_, wanted, station, water_depth_m_, ingested_.warnings);
      for (SeriesGroup& group : group_series(placed, times)) {
        check(group);
        if (group.levels.kind != VerticalKind::none && group.levels.levels_m.empty()) continue;
        add(group, position, station_name_of(file_, axes, station));
      }
    }
  }

  [[nodiscard]] std::size_t stations_outside() const noexcept { return outside_; }

 private:
  void check(SeriesGroup& group) {
    reject_side_lobes(group, ingested_.warnings);
    std::vector<UtcTime> stamps;
    for (const TimeCell& cell : group.times) stamps.push_back(cell.centre());
    std::vector<SeriesValues*> all;
    for (SeriesValues& series : group.series) all.push_back(&series);
    check_series(stamps, all, ingested_.warnings);
    keep_useful_levels(group, water_depth_m_, ingested_.warnings);
  }

  void add(SeriesGroup& group, const GeoPoint& position, const std::string& station) {
    Granule granule;
    granule.grid.time = group.times;
    granule.grid.vertical = group.levels.kind;
    granule.grid.levels_m = group.levels.levels_m;
    granule.grid.latitude_deg = {position.latitude_deg()};
    granule.grid.longitude_deg = {position.longitude_deg()};
    granule.is_point_series = true;
    granule.station = station;
    granule.water_depth_m = water_depth_m_;
    granule.product_id = product_.id;
    granule.dataset_id = file_.text("id").value_or("");
    granule.attribution = attribution_of(file_, product_, "Observations by");
    apply_status(granule, options_);
    for (const SeriesValues& series : group.series) {
      granule.variables.push_back(
          {series.standard_name, series.unit, series.source_name, false, true});
      if (series.standard_error && series.standard_name.ends_with("ward_sea_water_velocity"))
        granule.stated_error_m_s =
            std::max(granule.stated_error_m_s.value_or(0), *series.standard_error);
    }
    const auto content_file =
        staging_folder_ / ("series-" + std::to_string(ingested_.granules.size()) + ".nc");
    write_granule(content_file, granule, group);
    ingested_.granules.push_back({std::move(granule), content_file});
  }

  const netcdf::File& file_;
  const ProductCatalogue& products_;
  const Product& product_;
  const IngestOptions& options_;
  const std::filesystem::path& staging_folder_;
  Ingested& ingested_;
  std::optional<double> water_depth_m_;
  std::size_t outside_ = 0;
};

[[noreturn]] void refuse_without_wanted(const netcdf::File& file) {
  std::string names;
  for (const netcdf::Variable& variable : file.variables()) {
    if (names.size() < 200) names += (names.empty() ? "" : ", ") + variable.name;
  }
  refuse("found " + names +
         "; expected a current, wind or wave variable over time with its CF standard name");
}

}  // namespace

bool is_point_series(const netcdf::File& file) {
  if (spectrum_in(file) != nullptr) return true;
  if (is_gridded(file)) return false;
  if (says_series(file)) return true;
  const auto axes = station_axes_of(file);
  if (!axes) return false;
  const std::vector<std::string>& places = axes->latitude->dimensions;
  const bool over_time =
      std::find(places.begin(), places.end(), axes->time_dimension) != places.end();
  return axes->latitude->size() == 1 || over_time;
}

Ingested decode_point_series(const netcdf::File& file, const ProductCatalogue& products,
                             const IngestOptions& options,
                             const std::filesystem::path& staging_folder) {
  return with_context("reading point series " + file.path().filename().string(), [&] {
    if (const netcdf::Variable* spectrum = spectrum_in(file)) {
      refuse("'" + spectrum->name +
             "' is a wave spectrum over frequency; expected heights, periods, directions, "
             "wind or current over time: spectra are not ingested");
    }
    if (!options.as && file.text("title").value_or("").starts_with("Slackwater current forecast")) {
      refuse(
          "a forecast that Slackwater issued; expected observations: it would be taken for the "
          "truth that it is "
          "scored against. Say --as forecast --issued TIME if it is meant as a provider's "
          "forecast");
    }
    const std::vector<StationAxes> every_axis = all_station_axes_of(file);
    if (every_axis.empty()) {
      refuse(
          "found no time axis of one dimension, or no latitude and longitude of a station; "
          "expected a CF "
          "timeSeries or timeSeriesProfile (ragged and two-dimensional time axes are not read: "
          "write one file for "
          "each station)");
    }
    const Product& product = product_for(file, products, options);
    Ingested ingested;
    StagedFiles staged(ingested);
    SeriesDecoder decoder(file, products, product, options, staging_folder, ingested);
    bool any_wanted = false;
    for (const StationAxes& axes : every_axis) {
      std::vector<std::string> left_out;
      const std::vector<Wanted> wanted = wanted_in(file, axes, products, product, left_out);
      for (const std::string& statistic : left_out)
        ingested.warnings.push_back("left out as a statistic, not the quantity itself: " +
                                    statistic);
      if (wanted.empty()) continue;
      any_wanted = true;
      decoder.decode(axes, wanted);
    }
    if (!any_wanted && !ingested.warnings.empty())
      refuse("no series but these was found: " + ingested.warnings.back() +
             "; expected instants or means: fetch those instead");
    if (!any_wanted) refuse_without_wanted(file);
    if (ingested.granules.empty()) {
      if (decoder.stations_outside() > 0)
        refuse(
            "the station lies outside the box that was asked for; choose a --bbox or --site that "
            "holds it");
      refuse("no value was accepted: all are missing or rejected");
    }
    std::sort(ingested.warnings.begin(), ingested.warnings.end());
    ingested.warnings.erase(std::unique(ingested.warnings.begin(), ingested.warnings.end()),
                            ingested.warnings.end());
    staged.keep();
    return ingested;
  });
}

}  // namespace slackwater::ingest
