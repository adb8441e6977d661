#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "fields/base/error.h"
#include "ingest/cf/granule_file.h"
#include "ingest/copernicus/product_catalogue.h"
#include "ingest/insitu/series.h"
#include "ingest/netcdf/file.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::ingest::tests {

inline const ProductCatalogue& catalogue() {
  static const ProductCatalogue products =
      ProductCatalogue::load(slackwater::tests::source_folder() / "data" / "products");
  return products;
}

struct SeriesTest : ::testing::Test {
  slackwater::tests::TemporaryFolder folder;
  std::filesystem::path file = folder / "series.nc";
  IngestOptions options;

  Ingested decode(const std::filesystem::path& path) {
    return decode_point_series(netcdf::File::open(path), catalogue(), options, folder.path());
  }
  Ingested decode() { return decode(file); }

  std::string refusal() {
    try {
      static_cast<void>(decode());
    } catch (const Error& error) {
      return error.message();
    }
    return "nothing was refused";
  }

  static GriddedField read(const DecodedGranule& decoded, const std::string& name) {
    return GranuleFile::open(decoded.content_file)
        .read(name, 0, decoded.granule.grid.times(), 0, 1, 0, 1);
  }
  /// The granule that holds this quantity.
  static const DecodedGranule& holding(const Ingested& ingested, const std::string& name) {
    for (const DecodedGranule& decoded : ingested.granules) {
      for (const GranuleVariable& variable : decoded.granule.variables) {
        if (variable.standard_name == name) return decoded;
      }
    }
    throw Error(ErrorKind::not_found, "no granule holds " + name);
  }
  static std::size_t count(const GriddedField& field, SampleStatus status) {
    return static_cast<std::size_t>(std::count(field.status.begin(), field.status.end(), status));
  }
  static std::string all_of(const std::vector<std::string>& warnings) {
    std::string text;
    for (const std::string& warning : warnings) text += warning + "\n";
    return text;
  }
};

}  // namespace slackwater::ingest::tests
