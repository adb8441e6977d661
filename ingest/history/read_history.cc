#include "ingest/history/read_history.h"

#include <fstream>

#include "fields/base/error.h"
#include "ingest/grib/grib_file.h"
#include "ingest/history/cf_history.h"
#include "ingest/history/csv_history.h"
#include "ingest/netcdf/magic.h"
#include "ingest/text/foreign_file.h"

namespace slackwater::ingest {
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
    return netcdf::begins_as_netcdf(file) ? read_cf_history(file, wanted, options, vocabulary)
                                          : read_csv_history(file, wanted, options, vocabulary);
  } catch (Error& error) {
    if (error.message().find(file.string()) == std::string::npos) error.prepend(file.string());
    throw;
  }
}

}  // namespace slackwater::ingest
