#include "ingest/insitu/wave_spectra.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "ingest/cf/packing.h"
#include "ingest/cf/units.h"
#include "ingest/insitu/series_times.h"
#include "ingest/insitu/station.h"

namespace slackwater::ingest {
namespace {

constexpr std::size_t most_bands = 1000;  ///< instruments give 20 to 130
constexpr double highest_hz = 10.0;
/// A year of hourly spectra of 64 bands holds 0.6 million; a few bytes can claim any size.
constexpr std::size_t most_densities = 8'000'000;

constexpr std::string_view density_unit = "m2 Hz-1";
/// The same in the spelling of the archive, which UDUNITS cannot read.
constexpr std::string_view ndbc_density_unit = "(meter * meter)/Hz";

const netcdf::Variable& wanted(const netcdf::File& file, const char* name, const char* symbol) {
  if (const netcdf::Variable* found = file.find(name)) return *found;
  for (const netcdf::Variable& variable : file.variables()) {
    if (variable.text("short_name") == symbol) return variable;
  }
  refuse("no variable '" + std::string(name) + "' (" + symbol +
         "); expected an NDBC file of directional wave spectra");
}

/// Canonical values, NaN where missing. A variable without units is taken to be in canonical ones.
std::vector<double> values_of(const netcdf::File& file, const netcdf::Variable& variable,
                              const std::string& unit, std::vector<std::string>& warnings) {
  return with_context("variable '" + variable.name + "'", [&] {
    Packing packing = Packing::of(variable, warnings);
    const std::string found = variable.text("units").value_or(unit);
    const bool is_ndbc_density = found == ndbc_density_unit && unit == density_unit;
    if (found != unit && !is_ndbc_density) {
      packing.convert(unit_conversion(found, unit, variable.name));
    }
    const std::vector<double> raw = file.read_all(variable);
    std::vector<float> decoded(raw.size());
    DecodeCounts counts;
    packing.decode(raw, decoded, counts);
    return std::vector<double>(decoded.begin(), decoded.end());
  });
}

std::vector<double> frequencies_of(const netcdf::File& file, std::vector<std::string>& warnings) {
  const netcdf::Variable& variable = wanted(file, "frequency", "frequency");
  if (variable.shape.size() != 1 || variable.size() < 2 || variable.size() > most_bands) {
    refuse("'" + variable.name + "' has " + std::to_string(variable.shape.size()) +
           " dimensions and " + std::to_string(variable.size()) +
           " values; expected one dimension of 2 to 1000 bands");
  }
  std::vector<double> hz = values_of(file, variable, "Hz", warnings);
  double last = 0;
  for (const double f : hz) {
    if (!(f > last && f <= highest_hz)) {
      refuse("'" + variable.name + "' holds " + std::to_string(f) + " Hz after " +
             std::to_string(last) + " Hz; expected ascending frequencies up to 10 Hz");
    }
    last = f;
  }
  return hz;
}

/// Refuses what is not (time, frequency) with nothing beside it but lone values.
void expect_shape(const netcdf::Variable& variable, const StationAxes& axes,
                  const std::string& frequency_dimension) {
  if (variable.size() > most_densities) {
    refuse("'" + variable.name + "' claims " + std::to_string(variable.size()) +
           " values; expected at most " + std::to_string(most_densities) +
           ": cut the file by time");
  }
  std::vector<std::string> long_ones;
  for (std::size_t d = 0; d < variable.dimensions.size(); ++d) {
    const bool is_axis = variable.dimensions[d] == axes.time_dimension ||
                         variable.dimensions[d] == frequency_dimension;
    if (is_axis || variable.shape[d] != 1) long_ones.push_back(variable.dimensions[d]);
  }
  if (long_ones == std::vector{axes.time_dimension, frequency_dimension}) return;
  refuse("'" + variable.name + "' has the dimensions (" + joined(variable.dimensions, ", ") +
         "); expected (time, frequency) of one station");
}

/// A field over time and frequency.
std::vector<double> field_of(const netcdf::File& file, const netcdf::Variable& variable,
                             const std::string& unit, const StationAxes& axes,
                             const std::string& frequency_dimension,
                             std::vector<std::string>& warnings) {
  expect_shape(variable, axes, frequency_dimension);
  return values_of(file, variable, unit, warnings);
}

/// The rows of a file, time by band.
struct Rows {
  std::vector<double> density;
  std::vector<double> from_direction;
  std::vector<double> first_moment;
};

/// Makes a direction of each band whole or absent. Returns how many codes were no directions.
std::size_t clean_directions(Rows& rows) {
  std::size_t odd = 0;
  for (std::size_t i = 0; i < rows.from_direction.size(); ++i) {
    double& direction = rows.from_direction[i];
    double& r1 = rows.first_moment[i];
    const bool known = std::isfinite(direction) && std::isfinite(r1);
    const bool sound = direction >= 0 && direction <= 360 && r1 >= 0 && r1 <= 1;
    if (known && !sound) ++odd;
    if (!known || !sound) direction = r1 = std::nan("");
  }
  return odd;
}

/// The spectrum of one time; nothing where the energy of a band is not known.
std::optional<DirectionalSpectrum> spectrum_at(const Rows& rows, const std::vector<double>& hz,
                                               std::size_t t) {
  const auto part = [&](const std::vector<double>& all) {
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(t * hz.size());
    return std::vector<double>(first, first + static_cast<std::ptrdiff_t>(hz.size()));
  };
  DirectionalSpectrum spectrum{hz, part(rows.density), part(rows.from_direction),
                               part(rows.first_moment)};
  const auto known = [](double density) { return density >= 0 && std::isfinite(density); };
  const std::vector<double>& density = spectrum.density_m2_hz;
  if (!std::all_of(density.begin(), density.end(), known)) return std::nullopt;
  return spectrum;
}

WaveSpectra spectra_of(const netcdf::File& file) {
  const auto axes = station_axes_of(file);
  if (!axes || axes->stations != 1) {
    refuse(
        "no time, latitude and longitude of one station; expected an NDBC file of directional "
        "wave spectra");
  }
  WaveSpectra result;
  const std::vector<double> hz = frequencies_of(file, result.warnings);
  const std::string& bands = wanted(file, "frequency", "frequency").dimensions.front();
  const auto field = [&](const char* name, const char* symbol, std::string_view unit) {
    return field_of(file, wanted(file, name, symbol), std::string(unit), *axes, bands,
                    result.warnings);
  };
  Rows rows;
  rows.density = field("spectral_wave_density", "swden", density_unit);
  rows.from_direction = field("mean_wave_dir", "alpha1", "degree");
  rows.first_moment = field("wave_spectrum_r1", "r1", "1");
  const SeriesTimes times = series_times_of(file, *axes, result.warnings);
  if (rows.density.size() != times.cells.size() * hz.size()) {
    refuse("the density holds " + std::to_string(rows.density.size()) + " values; expected " +
           std::to_string(times.cells.size()) + " times of " + std::to_string(hz.size()) +
           " bands");
  }
  if (const std::size_t odd = clean_directions(rows); odd > 0) {
    result.warnings.push_back(
        std::to_string(odd) +
        " bands whose direction is not in 0 to 360 degrees or whose r1 is not "
        "in 0 to 1 taken without direction");
  }
  std::size_t left_out = 0;
  for (std::size_t t = 0; t < times.cells.size(); ++t) {
    if (!times.usable[t]) continue;
    if (auto spectrum = spectrum_at(rows, hz, t)) {
      result.time.push_back(times.cells[t].centre());
      result.spectrum.push_back(std::move(*spectrum));
    } else {
      ++left_out;
    }
  }
  if (left_out > 0) {
    result.warnings.push_back("left out " + std::to_string(left_out) +
                              " spectra in which the density of a band is missing or negative");
  }
  if (result.spectrum.empty()) refuse("holds no usable spectrum");
  result.point = position_of(file, *axes, 0, result.warnings);
  result.station = station_name_of(file, *axes, 0);
  return result;
}

}  // namespace

WaveSpectra read_wave_spectra(const std::filesystem::path& path) {
  return with_context("reading wave spectra from " + path.string(),
                      [&] { return spectra_of(netcdf::File::open(path)); });
}

}  // namespace slackwater::ingest
