#include "ingest/history/read_history.h"

#include <array>
#include <fstream>
#include <string_view>

#include "fields/base/error.h"
#include "ingest/grib/grib_file.h"
#include "ingest/history/cf_history.h"
#include "ingest/history/csv_history.h"
#include "ingest/text/foreign_file.h"

namespace slackwater::ingest {
namespace {

/// Classic NetCDF begins with "CDF", netCDF-4 as HDF5 does.
bool is_netcdf(const std::filesystem::path& file) {
  std::array<char, 4> magic{};
  std::ifstream(file, std::ios::binary).read(magic.data(), magic.size());
  const std::string_view found(magic.data(), magic.size());
  return found.starts_with("CDF") || found == "\x89HDF";
}

}  // namespace

HistoryOfFile read_history(const std::filesystem::path& file,
                           const std::vector<std::string>& wanted, const HistoryOptions& options,
                           const Vocabulary& vocabulary) {
  std::error_code problem;
  if (std::filesystem::is_directory(file, problem))
    throw Error(ErrorKind::invalid_input, "found the folder " + file.string() +
                                              " where a series was expected; name a file in it");
  if (!std::filesystem::is_regular_file(file, problem) || !std::ifstream(file))
    throw Error(ErrorKind::not_found, "cannot read " + file.string() + "; check the path");
  try {
    if (is_grib(file))
      throw Error(ErrorKind::invalid_input,
                  "found GRIB, expected a CSV table or a NetCDF series of one place; `slackwater "
                  "ingest` reads GRIB, then say --site");
    if (const auto foreign = foreign_file(file))
      refuse(foreign->refusal("a table or a NetCDF series of one place"));
    return is_netcdf(file) ? read_cf_history(file, wanted, options, vocabulary)
                           : read_csv_history(file, wanted, options, vocabulary);
  } catch (Error& error) {
    if (error.message().find(file.string()) == std::string::npos) error.prepend(file.string());
    throw;
  }
}

}  // namespace slackwater::ingest
