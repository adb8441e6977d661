#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "data/store/rows.h"
#include "fields/service/field.h"
#include "fields/service/sample_points.h"

namespace slackwater::api {

/// What is written, and from where.
struct Samples {
  store::ForecastRow row;
  std::shared_ptr<const Field> field;
  SampleGrid grid;
  std::vector<std::string> names;  ///< of the points; empty where their file has none
  std::size_t members = 1;         ///< the central one among them
  ValidRange range;
  StatusCounts counts{};
};

/// Samples and writes, block by block, and counts; `quiet`: no progress bar. Throws
/// Error(unavailable).
void write_netcdf(const std::filesystem::path& file, Samples& samples, bool quiet);
void write_csv(const std::filesystem::path& file, Samples& samples, bool quiet);

/// How many places have a value.
[[nodiscard]] std::size_t with_value(const StatusCounts& counts);
/// "ok 1200, below_bed 3".
[[nodiscard]] std::string counts_text(const StatusCounts& counts);

/// What was written, on standard output: schema in docs/json.md, a few lines for people.
void print_samples_json(const Samples& samples, const std::filesystem::path& out);
void print_samples(const Samples& samples, const std::filesystem::path& out);

}  // namespace slackwater::api
