#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "fields/base/error.h"
#include "ingest/cf/granule_file.h"
#include "ingest/copernicus/product_catalogue.h"
#include "ingest/grib/grib_file.h"
#include "ingest/grib/grib_writer.h"
#include "ingest/grib/message.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::ingest::tests {

/// A smooth wind that differs at every point, time and component: a value at the wrong place shows.
inline double wind_at(double latitude_deg, double longitude_deg, double step_h, bool east) {
  const double angle = 0.37 * latitude_deg + 0.21 * longitude_deg + 0.4 * step_h;
  return 9.0 * (east ? std::cos(angle) : std::sin(angle)) + 0.05 * longitude_deg -
         0.03 * latitude_deg;
}

inline std::vector<double> axis(double first, double step, std::size_t count) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(first + step * static_cast<double>(i));
  return values;
}

inline GribField wind_field(const std::string& short_name, UtcTime run, int step_h,
                            std::vector<double> latitude = axis(54.0, 0.25, 5),
                            std::vector<double> longitude = axis(5.0, 0.25, 7)) {
  GribField field;
  field.short_name = short_name;
  field.reference_time = run;
  field.step_hours = step_h;
  field.latitude_deg = std::move(latitude);
  field.longitude_deg = std::move(longitude);
  for (const double lat : field.latitude_deg) {
    for (const double lon : field.longitude_deg) {
      field.values.push_back(wind_at(lat, lon, step_h, short_name.back() == 'u'));
    }
  }
  return field;
}

/// Half a step of 24-bit packing of a field whose range is below 64 m/s, and float rounding of the
/// store.
constexpr double packing_m_s = 64.0 / (1 << 24) + 2e-6;

struct GribTest : ::testing::Test {
  slackwater::tests::TemporaryFolder folder;
  std::filesystem::path file = folder / "nwp.grib";
  IngestOptions options;
  UtcTime run = parse_utc("2024-02-28T12:00:00Z");

  Ingested decode() { return decode_grib(file, ProductCatalogue{}, options, folder.path()); }

  std::string refusal() {
    try {
      static_cast<void>(decode());
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
      return error.message();
    }
    return "nothing was refused";
  }

  static GriddedField read(const DecodedGranule& decoded, const std::string& name) {
    const auto content = GranuleFile::open(decoded.content_file);
    const Grid& grid = decoded.granule.grid;
    return content.read(name, 0, grid.times(), 0, grid.rows(), 0, grid.columns());
  }

  /// Writes messages that the plain writer cannot make: each is a 10u/10v pair of one field, bent
  /// by `bend`.
  void write_bent(int edition, const std::function<void(grib::Message&)>& bend,
                  const std::vector<std::string>& names = {"10u", "10v"}) const {
    std::ofstream stream(file, std::ios::binary);
    for (const std::string& name : names) {
      auto message = grib::Message::from_sample("regular_ll_sfc_grib" + std::to_string(edition));
      message.set("shortName", name);
      message.set("dataDate", 20240228L);
      message.set("dataTime", 1200L);
      message.set("stepRange", std::string("6"));
      bend(message);
      const auto bytes = message.bytes();
      stream.write(reinterpret_cast<const char*>(bytes.data()),
                   static_cast<std::streamsize>(bytes.size()));
    }
  }

  std::vector<char> contents() const {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  void write_contents(const std::vector<char>& bytes) const {
    std::ofstream stream(file, std::ios::binary);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
};

}  // namespace slackwater::ingest::tests
