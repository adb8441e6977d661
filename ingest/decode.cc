#include <string>

#include "fields/base/error.h"
#include "ingest/cf/settle.h"
#include "ingest/grib/grib_file.h"
#include "ingest/gridded.h"
#include "ingest/ingest.h"
#include "ingest/insitu/series.h"
#include "ingest/netcdf/file.h"
#include "ingest/publication.h"
#include "ingest/text/foreign_file.h"

namespace slackwater::ingest {
namespace {

Ingested decode_netcdf(const std::filesystem::path& path, const ProductCatalogue& products,
                       const IngestOptions& options, const std::filesystem::path& staging_folder,
                       const Progress& progress) {
  netcdf::File file = netcdf::File::open(path);
  settle(file, product_for(file, products, options), products.vocabulary());
  Ingested ingested = is_point_series(file)
                          ? decode_point_series(file, products, options, staging_folder)
                          : decode_gridded(file, products, options, staging_folder, progress);
  ingested.published = publication_of(file, ingested, options, ingested.warnings);
  return ingested;
}

}  // namespace

Ingested decode_file(const std::filesystem::path& file, const ProductCatalogue& products,
                     const IngestOptions& options, const std::filesystem::path& staging_folder,
                     const Progress& progress) {
  try {
    if (std::filesystem::is_regular_file(file) && is_grib(file)) {
      return decode_grib(file, products, options, staging_folder, progress);
    }
    if (const auto foreign = foreign_file_or_text(file)) refuse(foreign->refusal("NetCDF or GRIB"));
    return decode_netcdf(file, products, options, staging_folder, progress);
  } catch (Error& error) {
    // The wrappers of the libraries name the file themselves.
    if (error.message().find(file.string()) == std::string::npos) error.prepend(file.string());
    throw;
  }
}

}  // namespace slackwater::ingest
