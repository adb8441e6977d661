#include "ingest/insitu/wave_spectra.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "fields/base/error.h"
#include "fields/base/random.h"
#include "fields/wave/sea_realisation.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::ingest::tests {
namespace {

using netcdf::Type;
using netcdf::Writer;

constexpr double fill = -32767.0;

/// What a file may ask of the reader.
struct Recipe {
  std::size_t times = 3;
  std::vector<double> frequency{0.05, 0.1, 0.2, 0.3};
  std::string frequency_units = "Hz";
  std::string density_units = "(meter * meter)/Hz";
  std::string density_name = "spectral_wave_density";
  double scale = 1e-5;
  double odd_density = 50000;  ///< coded, at the second time, third band
  double odd_direction = 9e6;  ///< coded, likewise
  double odd_r1 = 80000;       ///< coded, likewise
  std::size_t longitudes = 1;
  bool frequency_first = false;
  bool with_r1 = true;
};

class WaveSpectraFile : public ::testing::Test {
 protected:
  slackwater::tests::TemporaryFolder folder;
  std::filesystem::path file = folder / "spectra.nc";

  /// Density 0.5 m2/Hz from 90 degrees with r1 0.8 throughout, but for one odd band.
  void write(const Recipe& r) const {
    Writer writer = Writer::create(file);
    const int time_dimension = writer.dimension("time", r.times);
    const int bands = writer.dimension("frequency", r.frequency.size());
    const int latitudes = writer.dimension("latitude", 1);
    const int longitudes = writer.dimension("longitude", r.longitudes);
    const int time = writer.variable("time", Type::int32, {time_dimension});
    writer.attribute(time, "units", "seconds since 1970-01-01T00:00:00+00:00");
    writer.attribute(time, "standard_name", "time");
    const int frequency = writer.variable("frequency", Type::float64, {bands});
    writer.attribute(frequency, "units", r.frequency_units);
    const int latitude = writer.variable("latitude", Type::float32, {latitudes});
    writer.attribute(latitude, "units", "degrees_north");
    const int longitude = writer.variable("longitude", Type::float32, {longitudes});
    writer.attribute(longitude, "units", "degrees_east");
    std::vector<int> shape{time_dimension, bands, latitudes, longitudes};
    if (r.frequency_first) std::swap(shape[0], shape[1]);
    const auto coded = [&](const std::string& name, const std::string& units) {
      const int id = writer.variable(name, Type::int32, shape, {{}, 0, fill});
      if (!units.empty()) writer.attribute(id, "units", units);
      writer.attribute(id, "scale_factor", r.scale);
      return id;
    };
    const int density = coded(r.density_name, r.density_units);
    const int direction = coded("mean_wave_dir", "degrees_true");
    const int r1 = r.with_r1 ? coded("wave_spectrum_r1", "") : -1;
    writer.attribute(Writer::global, "station", "B7");
    writer.end_definitions();
    std::vector<double> stamps;
    for (std::size_t t = 0; t < r.times; ++t) {
      stamps.push_back(1.5e9 + 3600.0 * static_cast<double>(t));
    }
    writer.write_all(time, stamps);
    writer.write_all(frequency, r.frequency);
    writer.write_all(latitude, std::vector<double>{54.0});
    writer.write_all(longitude, std::vector<double>(r.longitudes, 7.0));
    const auto rows = [&](double usual, double odd) {
      std::vector<double> all(r.times * r.frequency.size() * r.longitudes, usual);
      if (all.size() > r.frequency.size() + 2) all[r.frequency.size() + 2] = odd;
      return all;
    };
    writer.write_all(density, rows(50000, r.odd_density));
    writer.write_all(direction, rows(9e6, r.odd_direction));
    if (r.with_r1) writer.write_all(r1, rows(80000, r.odd_r1));
    writer.close();
  }

  [[nodiscard]] std::string refusal() const {
    try {
      static_cast<void>(read_wave_spectra(file));
    } catch (const Error& error) {
      EXPECT_NE(error.message().find(file.string()), std::string::npos) << error.message();
      EXPECT_TRUE(error.kind() == ErrorKind::invalid_input || error.kind() == ErrorKind::not_found);
      return error.message();
    }
    return "nothing was refused";
  }
  static bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }
};

TEST_F(WaveSpectraFile, CodedIntegersBecomeDensitiesAndDirections) {
  write({});
  const WaveSpectra spectra = read_wave_spectra(file);
  EXPECT_EQ(spectra.station, "B7");
  EXPECT_EQ(spectra.point.latitude_deg(), 54.0);
  ASSERT_EQ(spectra.spectrum.size(), 3u);
  EXPECT_EQ(format_utc(spectra.time[1]), "2017-07-14T03:40:00Z");
  for (const DirectionalSpectrum& spectrum : spectra.spectrum) {
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(spectrum.density_m2_hz[i], 0.5, 1e-7);
      EXPECT_NEAR(spectrum.from_direction_deg[i], 90.0, 1e-5);
      EXPECT_NEAR(spectrum.first_moment[i], 0.8, 1e-7);
    }
  }
  EXPECT_TRUE(spectra.warnings.empty());
}

TEST_F(WaveSpectraFile, ATimeOfUnknownEnergyIsLeftOutAndTold) {
  for (const double odd : {fill, -3.0}) {
    write({.odd_density = odd});
    const WaveSpectra spectra = read_wave_spectra(file);
    ASSERT_EQ(spectra.spectrum.size(), 2u);
    EXPECT_EQ(spectra.time.size(), 2u);
    ASSERT_EQ(spectra.warnings.size(), 1u);
    EXPECT_TRUE(holds(spectra.warnings[0], "left out 1 spectra")) << spectra.warnings[0];
  }
}

TEST_F(WaveSpectraFile, ABandWithoutDirectionKeepsItsEnergy) {
  write({.odd_direction = fill});
  const WaveSpectra missing = read_wave_spectra(file);
  EXPECT_TRUE(std::isnan(missing.spectrum[1].from_direction_deg[2]));
  EXPECT_TRUE(std::isnan(missing.spectrum[1].first_moment[2]));
  EXPECT_NEAR(missing.spectrum[1].density_m2_hz[2], 0.5, 1e-7);
  EXPECT_TRUE(missing.warnings.empty());
  write({.odd_r1 = 999e5});
  const WaveSpectra odd = read_wave_spectra(file);
  EXPECT_TRUE(std::isnan(odd.spectrum[1].from_direction_deg[2]));
  ASSERT_EQ(odd.warnings.size(), 1u);
  EXPECT_TRUE(holds(odd.warnings[0], "1 bands whose direction"));
}

TEST_F(WaveSpectraFile, WhatIsNotSuchAFileIsRefusedWithAReason) {
  EXPECT_TRUE(holds(refusal(), "no such file")) << refusal();
  write({.frequency = {0.1, 0.05, 0.2, 0.3}});
  EXPECT_TRUE(holds(refusal(), "expected ascending frequencies")) << refusal();
  write({.frequency = {0.0, 0.1, 0.2, 0.3}});
  EXPECT_TRUE(holds(refusal(), "expected ascending frequencies"));
  write({.frequency = {0.05, std::nan(""), 0.2, 0.3}});
  EXPECT_TRUE(holds(refusal(), "expected ascending frequencies"));
  write({.frequency = {0.1}});
  EXPECT_TRUE(holds(refusal(), "2 to 1000 bands"));
  write({.frequency_units = "metre"});
  EXPECT_TRUE(holds(refusal(), "frequency")) << refusal();
  write({.density_units = "m/s"});
  EXPECT_TRUE(holds(refusal(), "spectral_wave_density")) << refusal();
  write({.density_name = "something"});
  EXPECT_TRUE(holds(refusal(), "no variable 'spectral_wave_density'"));
  write({.with_r1 = false});
  EXPECT_TRUE(holds(refusal(), "no variable 'wave_spectrum_r1'"));
  write({.scale = 0.0});
  EXPECT_TRUE(holds(refusal(), "scale")) << refusal();
  write({.frequency_first = true});
  EXPECT_TRUE(holds(refusal(), "expected (time, frequency)")) << refusal();
  write({.longitudes = 2});
  EXPECT_NE(refusal(), "nothing was refused");
  write({.times = 1, .frequency = {0.1, 0.2}, .scale = -1.0});
  EXPECT_TRUE(holds(refusal(), "no usable spectrum")) << refusal();
}

TEST_F(WaveSpectraFile, DamageIsOneErrorOrHarmless) {
  write({.times = 50});
  std::ifstream stream(file, std::ios::binary);
  const std::string whole((std::istreambuf_iterator<char>(stream)), {});
  Rng rng(5, "wave_spectra_damage");
  int refused = 0;
  for (int i = 0; i < 150; ++i) {
    std::string damaged = whole;
    if (i % 3 == 0) {
      damaged.resize(static_cast<std::size_t>(rng.uniform() * static_cast<double>(whole.size())));
    } else {
      for (int hit = 0; hit < 20; ++hit) {
        damaged[static_cast<std::size_t>(rng.uniform() * static_cast<double>(whole.size()))] =
            static_cast<char>(rng.bits() & 0xFFU);
      }
    }
    std::ofstream(file, std::ios::binary | std::ios::trunc) << damaged;
    refused += refusal() == "nothing was refused" ? 0 : 1;
  }
  EXPECT_GT(refused, 50);  // every truncated one at least
}

TEST(WaveSpectraOfABuoy, AreThoseThatNumPyMakesOfTheFile) {
  SLACKWATER_NEEDS_SHARED(shared);
  const WaveSpectra spectra = read_wave_spectra(shared / "data" / "spectra" / "42098w9999.nc");
  EXPECT_EQ(spectra.station, "42098");
  EXPECT_NEAR(spectra.point.latitude_deg(), 27.590, 1e-4);
  EXPECT_NEAR(spectra.point.longitude_deg(), -82.931, 1e-4);
  ASSERT_EQ(spectra.spectrum.size(), 100u);
  EXPECT_EQ(format_utc(spectra.time.front()), "2015-06-09T11:00:00Z");
  // netCDF4 1.7 and NumPy in double: 4 sqrt(sum S df), 1/f at the peak, sqrt(m0/m2), alpha1.
  const SpectrumSummary mid = summary_of(spectra.spectrum[50]);
  EXPECT_NEAR(mid.significant_height_m, 0.7709734131, 1e-6);
  EXPECT_NEAR(mid.peak_period_s, 4.7619049106, 1e-6);
  EXPECT_NEAR(mid.mean_period_s, 3.7417394993, 1e-6);
  EXPECT_NEAR(mid.from_direction_deg, 200.0, 1e-4);
  EXPECT_NEAR(mid.spread_deg, 24.3085, 1e-3);  // r1 = 0.91
  const SpectrumSummary last = summary_of(spectra.spectrum[99]);
  EXPECT_NEAR(last.significant_height_m, 0.8559018662, 1e-6);
  EXPECT_NEAR(last.from_direction_deg, 172.0, 1e-4);
  // The first is calm but for a ripple without direction.
  const SpectrumSummary first = summary_of(spectra.spectrum[0]);
  EXPECT_NEAR(first.significant_height_m, 0.1788854384, 1e-6);
  EXPECT_TRUE(std::isnan(first.from_direction_deg));
}

TEST(WaveSpectraOfABuoy, BecomeSeasOfTheirHeightAndDirection) {
  SLACKWATER_NEEDS_SHARED(shared);
  const WaveSpectra spectra = read_wave_spectra(shared / "data" / "spectra" / "42098w9999.nc");
  int made = 0;
  for (std::size_t i = 0; i < spectra.spectrum.size(); i += 7) {
    const SpectrumSummary summary = summary_of(spectra.spectrum[i]);
    if (std::isnan(summary.from_direction_deg)) continue;
    ++made;
    const SeaRealisation sea = realise(spectra.spectrum[i], {11.0, {}}, i, spectra.time[i]);
    EXPECT_NEAR(sea.significant_height_m(), summary.significant_height_m, 1e-9);
    // Mean direction by energy: of the bands as measured, and of the sinusoids as drawn.
    const std::vector<double> widths = band_widths_hz(spectra.spectrum[i].frequency_hz);
    Horizontal measured{};
    for (std::size_t band = 0; band < widths.size(); ++band) {
      const double r1 = spectra.spectrum[i].first_moment[band];
      if (std::isnan(r1)) continue;
      measured += vector_from_direction(r1 * spectra.spectrum[i].density_m2_hz[band] * widths[band],
                                        spectra.spectrum[i].from_direction_deg[band]);
    }
    Horizontal drawn{};
    for (const WaveComponent& wave : sea.waves()) {
      drawn += 0.5 * wave.amplitude_m * wave.amplitude_m * wave.wavenumber_rad_m /
               std::abs(wave.wavenumber_rad_m);
    }
    const double off = std::arg(drawn * std::conj(measured));
    EXPECT_LT(std::abs(off), Angle::from_degrees(6.0).radians()) << i;
    EXPECT_NEAR(std::abs(drawn) / std::abs(measured), 1.0, 0.06) << i;
  }
  EXPECT_GE(made, 8);
}

}  // namespace
}  // namespace slackwater::ingest::tests
