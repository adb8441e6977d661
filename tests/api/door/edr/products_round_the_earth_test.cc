// Stored products across the antimeridian and round the Earth.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "tests/api/door/edr/stored_products_for_tests.h"

namespace slackwater::tests::edr_products {
namespace {

TEST(EdrProductsRoundTheEarth, TheAntimeridianIsNoBorder) {
  ProductServiceForTests service;
  ProductForTests product = wind_product(day, 3);
  product.longitude_deg = {179.8, 179.9, 180, 180.1, 180.2};
  product.latitude_deg = {-17.1, -17, -16.9};
  product.quantity("eastward_wind").value = [](const ProductCell& cell) {
    return cell.longitude_deg - 175;
  };
  service.with(product);
  const std::string instant = "2025-03-10T01:00:00Z";
  for (const char* coords : {"POINT(-179.9 -17)", "POINT(180.1 -17)"}) {
    const json answer = service.document(std::string(wind) + "/position",
                                         {{"coords", coords}, {"datetime", instant}});
    EXPECT_NEAR(values_of(answer, "eastward_wind").front(), 5.1, rounding) << coords;
  }
  const json across = service.document(
      std::string(wind) + "/cube",
      {{"bbox", "179.85,-17.05,-179.85,-16.95"}, {"z", "10"}, {"datetime", instant}});
  const auto east = values_of(across, "eastward_wind");
  ASSERT_EQ(east.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(east[i], 4.9 + 0.1 * static_cast<double>(i), rounding);
}

/// A wind round the Earth, cells ten degrees apart, whose columns begin at a longitude.
ProductForTests global_wind(double west_deg) {
  ProductForTests product = wind_product(day, 1);
  product.longitude_deg.clear();
  product.latitude_deg.clear();
  for (int i = 0; i < 36; ++i) product.longitude_deg.push_back(west_deg + 10 * i);
  for (int j = -8; j <= 8; ++j) product.latitude_deg.push_back(10 * j);
  return product;
}

/// That wind at a cell, whichever turn its longitude is counted in.
double global_eastward_m_s(double longitude_deg, double latitude_deg) {
  return 0.1 * latitude_deg + std::cos(longitude_deg * std::acos(-1.0) / 180);
}

TEST(EdrProductsRoundTheEarth, AProductRoundTheEarthHasNoSeam) {
  for (const double west_deg : {-180.0, 0.0}) {
    ProductServiceForTests service;
    ProductForTests product = global_wind(west_deg);
    product.quantity("eastward_wind").value = [](const ProductCell& cell) {
      return global_eastward_m_s(cell.longitude_deg, cell.latitude_deg);
    };
    service.with(product);
    for (const auto& [bbox, columns, rows] :
         {std::tuple{"-180,-80,180,80", 36U, 17U}, std::tuple{"0,-80,359,80", 36U, 17U},
          std::tuple{"170,-10,-170,10", 3U, 3U}, std::tuple{"-20,-10,20,10", 5U, 3U},
          std::tuple{"160,-1,350,1", 20U, 1U}}) {
      const json answer =
          service.document(std::string(wind) + "/cube", {{"bbox", bbox}, {"z", "10"}});
      const json& axes = answer.at("domain").at("axes");
      const json& x = axes.at("x").at("values");
      const json& y = axes.at("y").at("values");
      EXPECT_EQ(x.size(), columns) << west_deg << " " << bbox;
      EXPECT_EQ(y.size(), rows) << west_deg << " " << bbox;
      const auto east = values_of(answer, "eastward_wind");
      ASSERT_EQ(east.size(), x.size() * y.size());
      for (std::size_t i = 0; i < east.size(); ++i)
        ASSERT_NEAR(east[i], global_eastward_m_s(x[i % x.size()], y[i / x.size()]), rounding)
            << west_deg << " " << bbox << " " << x[i % x.size()];
    }
    for (const double x : {-180.0, -175.0, -5.0, 0.0, 5.0, 175.0, 180.0, 355.0}) {
      const json answer = service.document(std::string(wind) + "/position",
                                           {{"coords", "POINT(" + std::to_string(x) + " 50)"}});
      const double low = 10 * std::floor(x / 10);
      const double share = (x - low) / 10;
      const double expected =
          (1 - share) * global_eastward_m_s(low, 50) + share * global_eastward_m_s(low + 10, 50);
      EXPECT_NEAR(values_of(answer, "eastward_wind").front(), expected, rounding)
          << west_deg << " " << x;
    }
    const json coarse = service.document(
        std::string(wind) + "/cube",
        {{"bbox", "-180,-80,180,80"}, {"z", "10"}, {"resolution-x", "5"}, {"resolution-y", "1"}});
    EXPECT_EQ(coarse.at("domain").at("axes").at("x").at("values"),
              json::array({-180.0, -90.0, 0.0, 90.0, 180.0}))
        << "as they were asked";
    const std::vector<double> of_quarters{-1, 0, 1, 0, -1};
    const auto quarters = values_of(coarse, "eastward_wind");
    ASSERT_EQ(quarters.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(quarters[i], of_quarters[i], rounding) << i;
    for (const auto& [coords, cells] :
         {std::pair{"POLYGON((165 5,195 5,195 25,165 25,165 5))", 6U},
          std::pair{"POLYGON((-180 5,-165 5,-165 25,-180 25,-180 5))", 4U},
          std::pair{"POLYGON((-15 5,15 5,15 25,-15 25,-15 5))", 6U}}) {
      const auto east = values_of(
          service.document(std::string(wind) + "/area", {{"coords", coords}}), "eastward_wind");
      EXPECT_EQ(east.size(), cells) << coords;
      EXPECT_TRUE(std::none_of(east.begin(), east.end(), [](double v) { return std::isnan(v); }))
          << west_deg << " " << coords;
    }
    const json ends = service.document(std::string(wind) + "/position",
                                       {{"coords", "MULTIPOINT((-180 20),(180 20))"}});
    for (const json& end : ends.at("coverages"))
      EXPECT_NEAR(values_of(end, "eastward_wind").front(), 1, rounding) << west_deg;
  }
}

TEST(EdrProductsRoundTheEarth, BothEndsOfAProductNearlyRoundTheEarthAreAnswered) {
  ProductServiceForTests service;
  ProductForTests product = global_wind(20);
  product.longitude_deg.resize(33);  // 20 to 340
  product.quantity("eastward_wind").value = [](const ProductCell& cell) {
    return cell.longitude_deg / 100;
  };
  service.with(product);
  const json answer =
      service.document(std::string(wind) + "/cube", {{"bbox", "-30,-1,30,1"}, {"z", "10"}});
  EXPECT_EQ(answer.at("domain").at("axes").at("x").at("values"),
            json::array({-30.0, -20.0, 20.0, 30.0}));
  const auto east = values_of(answer, "eastward_wind");
  const std::vector<double> expected{3.3, 3.4, 0.2, 0.3};
  ASSERT_EQ(east.size(), expected.size());
  for (std::size_t i = 0; i < east.size(); ++i) EXPECT_NEAR(east[i], expected[i], rounding) << i;
}

}  // namespace
}  // namespace slackwater::tests::edr_products
