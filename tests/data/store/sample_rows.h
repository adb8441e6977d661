#pragma once
#include <fcntl.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "data/store/rows.h"
#include "data/store/store.h"
#include "fields/base/encode/sha256.h"

/// Rows and content that are functions of a number, so that a test and a worker process agree on
/// them.
namespace slackwater::store::samples {

/// Content of granule `part` of source `number`: bytes that no other granule has, 5 to 40 kB.
inline std::string content_of(int number, int part) {
  const std::string line =
      "source " + std::to_string(number) + " part " + std::to_string(part) + "\n";
  std::string bytes;
  const std::size_t size =
      5000U + static_cast<std::size_t>((number * 7919 + part * 104729) % 35000);
  while (bytes.size() < size) bytes += line;
  return bytes;
}

/// Through plain system calls, which the interposed libc sees.
inline std::string read_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline void write_file(const std::filesystem::path& file, const std::string& bytes) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) throw std::runtime_error("cannot make " + file.string());
  const bool whole =
      ::write(descriptor, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
  ::close(descriptor);
  if (!whole) throw std::runtime_error("cannot write " + file.string());
}

inline SourceFile source(int number) {
  SourceFile source;
  source.sha256 = sha256_of_text("product file " + std::to_string(number));
  source.name = "product_" + std::to_string(number) + ".nc";
  source.bytes = 1000U + static_cast<std::uint64_t>(number);
  source.product_id = "MEDSEA_ANALYSISFORECAST_PHY_006_013";
  source.dataset_id = "cmems_mod_med_phy-cur_anfc_4.2km_PT1H-m";
  source.attribution = "Generated using E.U. Copernicus Marine Service Information";
  source.ingested_at = parse_utc("2024-03-01T05:00:00Z") + std::chrono::minutes(number);
  source.warnings = {"first warning", "second warning"};
  return source;
}

inline GranuleRow granule_row(int number) {
  GranuleRow row;
  row.standard_names = {"eastward_sea_water_velocity", "northward_sea_water_velocity"};
  row.first_time = parse_utc("2024-02-29T00:00:00Z") + std::chrono::days(number);
  row.last_time = *row.first_time + std::chrono::hours(24);
  row.times = 24;
  row.bounds = {18.0, 40.0, 19.0, 41.0};
  row.vertical = VerticalKind::depth_m;
  row.lowest_level_m = 1.018;
  row.highest_level_m = 35.5;
  row.product_id = source(number).product_id;
  row.dataset_id = source(number).dataset_id;
  row.attribution = source(number).attribution;
  return row;
}

/// Two granules per source, their content freshly staged.
inline std::vector<NewGranule> granules(Store& store, int number) {
  std::vector<NewGranule> granules;
  for (int part = 0; part < 2; ++part) {
    const auto file = store.staging_folder() /
                      ("source-" + std::to_string(number) + "-" + std::to_string(part) + ".nc");
    write_file(file, content_of(number, part));
    granules.push_back({granule_row(number), file});
  }
  return granules;
}

inline bool ingest(Store& store, int number) {
  return store.commit_ingest(source(number), granules(store, number));
}

inline std::string forecast_content(int number) { return content_of(number, 1000); }

inline ForecastRow forecast_row(int number, std::vector<std::int64_t> inputs = {}) {
  ForecastRow row;
  row.site_id = "otranto";
  row.day = parse_day("2024-02-29") + std::chrono::days(number);
  row.issued = UtcTime(row.day) + std::chrono::hours(29);
  row.valid_from = UtcTime(row.day) + std::chrono::hours(24);
  row.valid_to = row.valid_from + std::chrono::hours(72);
  row.headline = "Forecast " + std::to_string(number);
  row.summary_json = R"({"misfit_m_s": 0.03})";
  row.code_version = "0.1.0";
  row.input_granules = std::move(inputs);
  return row;
}

inline std::int64_t issue(Store& store, int number, std::vector<std::int64_t> inputs = {}) {
  const auto file = store.staging_folder() / ("forecast-" + std::to_string(number) + ".nc");
  write_file(file, forecast_content(number));
  return store.commit_forecast(forecast_row(number, std::move(inputs)), file).id;
}

}  // namespace slackwater::store::samples
