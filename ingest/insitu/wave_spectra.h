#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "fields/base/time.h"
#include "fields/geo/geo_point.h"
#include "fields/wave/directional_spectrum.h"
#include "ingest/netcdf/file.h"

namespace slackwater::ingest {

/// The directional wave spectra of one buoy.
struct WaveSpectra {
  std::string station;
  GeoPoint point;
  std::vector<UtcTime> time;                  ///< ascending
  std::vector<DirectionalSpectrum> spectrum;  ///< one for each time
  std::vector<std::string> warnings;
};

/// Reads the NetCDF files of the US National Data Buoy Center:
///
///   spectral_wave_density (time, frequency, ...)  c11, m2/Hz, coded or not
///   mean_wave_dir                                 alpha1, degrees true, where waves come from
///   wave_spectrum_r1                              r1, 0 to 1
///
/// with `frequency` in Hz; other dimensions (latitude, longitude) have length 1. alpha2 and r2 are
/// left: `DirectionalSpectrum` says what is kept. A band without a direction keeps its energy; a
/// direction outside [0, 360] or an r1 outside [0, 1] (codes for missing, such as 999) is none, and
/// told. A time at which the density of any band is missing or negative is left out, and told:
/// energy that is not known is not zero.
///
/// Throws Error(not_found) where there is no file; Error(invalid_input), with the path, for a file
/// that is no NetCDF, is damaged, lacks one of these variables, has them in other shapes or units,
/// has frequencies that are not ascending within (0, 10] Hz, or holds no usable spectrum.
/// Source: NDBC Technical Document 96-01; NDBC, "Measurement descriptions and units".
[[nodiscard]] WaveSpectra read_wave_spectra(const std::filesystem::path& path);

}  // namespace slackwater::ingest
