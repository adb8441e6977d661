// Who is credited is what the file says, never what its layout resembles.
#include "ingest/cf/attribution.h"

#include <gtest/gtest.h>

#include "tests/ingest/cf/tiny_product.h"

namespace slackwater::ingest::attribution_test {
namespace {

using slackwater::ingest::tests::decode;
using slackwater::ingest::tests::TinyProduct;

/// Wind at 10 m as weather models' files hold it, with both components.
TinyProduct wind(const std::map<std::string, std::string>& says) {
  TinyProduct product;
  product.name = "u10";
  product.standard_name = "";
  product.unit = "m s**-1";
  product.depth.clear();
  product.order = {"time", "latitude", "longitude"};
  product.global = says;
  product.more = [](netcdf::Writer& writer, int, const std::map<std::string, int>& d) {
    const int id = writer.variable("v10", netcdf::Type::float32,
                                   {d.at("time"), d.at("latitude"), d.at("longitude")});
    writer.attribute(id, "units", "m s**-1");
    return [id](netcdf::Writer& w) { w.write_all(id, std::vector<double>(36, 1.0)); };
  };
  return product;
}

TEST(Attribution, WindThatNamesNobodyCreditsNobody) {
  const Granule granule = decode(wind({})).granule();
  EXPECT_EQ(granule.attribution, "Source not named in the file");
  EXPECT_EQ(granule.product_id, "unnamed_weather");
}

TEST(Attribution, TheToolThatWroteAFileIsNotItsMaker) {
  for (const char* history :
       {"2025-03-01 by grib_to_netcdf-2.25.1: grib_to_netcdf -S param -o out.nc gfs.grib",
        "2025-03-01 GRIB to CDM+CF via cfgrib-0.9.14.1/ecCodes-2.36.0"}) {
    const Granule granule = decode(wind({{"history", history}})).granule();
    EXPECT_EQ(granule.attribution, "Source not named in the file") << history;
  }
}

TEST(Attribution, TheMakerThatAFileNamesIsCreditedAndNobodyBeside) {
  const auto credit = [](const std::map<std::string, std::string>& says) {
    return decode(wind(says)).granule().attribution;
  };
  const std::string ecmwf = "European Centre for Medium-Range Weather Forecasts";
  EXPECT_EQ(credit({{"institution", ecmwf}}), "Contains data of the " + ecmwf + " (ECMWF)");
  EXPECT_EQ(credit({{"history", "by grib_to_netcdf: -o /cache/adaptor.mars.internal-16.nc"}}),
            "Contains modified Copernicus Climate Change Service information and ECMWF data "
            "(CC-BY 4.0)");
  EXPECT_EQ(credit({{"institution", "Harbour Office"}}), "Data of Harbour Office");
  EXPECT_EQ(credit({{"institution", "Harbour Office"}, {"citation", "Cite us."}}), "Cite us.");
  EXPECT_EQ(credit({{"institution", "  "}, {"title", "Wind of yesterday"}}),
            "Maker not named in the file; it calls itself: Wind of yesterday");
}

TEST(Attribution, AModelsNameAloneIsNoProductOfCopernicus) {
  for (const char* source : {"MFS EAS8", "NEMO GLO12", "PSY4V3R1", "AMM15 NEMO", "FOAM-NWSO"}) {
    TinyProduct product;
    product.global = {{"source", source}, {"institution", "A University"}};
    const Granule granule = decode(product).granule();
    EXPECT_EQ(granule.attribution, "Data of A University") << source;
  }
  TinyProduct copernicus;
  copernicus.global = {{"source", "MOI GLO12"},
                       {"credit", "E.U. Copernicus Marine Service Information (CMEMS)"}};
  EXPECT_EQ(decode(copernicus).granule().product_id, "GLOBAL_ANALYSISFORECAST_PHY_001_024");
}

}  // namespace
}  // namespace slackwater::ingest::attribution_test
