#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "api/pipeline/load_site_data.h"
#include "calibration/fuse/instrument_check.h"
#include "fields/base/numbers/random.h"
#include "tests/scenarios/real_pairs.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

// Real profilers beside made-up products: the water has everything that made-up water lacks, and
// none of it may be taken for a fault of the instrument. No product is held for these moorings.

namespace slackwater::tests::real_instruments_test {
namespace {

using calibration::MooredInstrumentUse;
using calibration::MooredInstrumentVerdict;

struct Mooring {
  const char* file;
  double latitude_deg;
  double longitude_deg;
  UtcDay first;
  int days;
};

const Mooring rottnest{"IMOS", -32.0, 115.4, parse_day("2018-08-16"), 7};
const Mooring washington{"eh2", 47.60, -124.59, parse_day("2005-05-30"), 45};

VectorColumn column_of(const Mooring& mooring, const std::filesystem::path& shared) {
  const TemporaryFolder folder;
  store::Store store = store::Store::open(folder / "store", store::OpenMode::create_or_write);
  for (const auto& entry : std::filesystem::directory_iterator(shared / "data/adcp")) {
    if (entry.path().filename().string().starts_with(mooring.file))
      ingest_all(store, {entry.path()}, false);
  }
  Site site =
      site_of(mooring.file, {GeoPoint::from_degrees(mooring.latitude_deg, mooring.longitude_deg)});
  site.columns.clear();
  const SiteData data =
      api::load_site_data(store, site, UtcTime(mooring.first),
                          UtcTime(mooring.first) + std::chrono::days(mooring.days));
  return data.columns.at(0).current.pieces.at(0).column;
}

/// The mooring's water as an hourly product of another place and turn of mind: seen through a
/// running mean, late, turned, larger, with errors of its own.
struct ProductOfIt {
  double mean_h = 1;
  double late_h = 0;
  double turned_deg = 0;
  double larger = 1;
  double error_m_s = 0;
  double step_h = 1;
};

VectorColumn product_of(const VectorColumn& seen, const ProductOfIt& how) {
  VectorColumn product;
  product.vertical = VerticalKind::depth_m;
  product.levels_m = seen.levels_m;
  Rng random(11, "product of a mooring");
  Horizontal error = how.error_m_s * Horizontal{random.normal(), random.normal()};
  const double a = std::exp(-how.step_h / 72);
  const Horizontal turn = std::polar(how.larger, -how.turned_deg * std::numbers::pi / 180);
  const UtcTime end = seen.time.back().centre();
  for (UtcTime time = seen.time.front().centre(); time <= end; time = add_hours(time, how.step_h)) {
    product.time.push_back(TimeCell::instant(time));
    product.source.push_back(DataStatus::analysis);
    error = a * error +
            how.error_m_s * std::sqrt(1 - a * a) * Horizontal{random.normal(), random.normal()};
    const UtcTime middle = add_hours(time, -how.late_h);
    const Duration half(static_cast<Duration::rep>(how.mean_h * 1.8e6));
    for (std::size_t k = 0; k < seen.levels(); ++k) {
      Horizontal sum{};
      double count = 0;
      auto cell = std::lower_bound(seen.time.begin(), seen.time.end(), middle - half,
                                   [](const TimeCell& one, UtcTime t) { return one.centre() < t; });
      for (; cell != seen.time.end() && cell->centre() <= middle + half; ++cell) {
        const auto t = static_cast<std::size_t>(cell - seen.time.begin());
        if (!seen.has(t, k)) continue;
        sum += seen.value[seen.offset(t, k)];
        ++count;
      }
      product.status.push_back(count > 0 ? SampleStatus::ok : SampleStatus::missing);
      product.value.push_back(count > 0 ? turn * sum / count + error : Horizontal{});
    }
  }
  return product;
}

TEST(RealInstruments, AreUsedBesideProductsOfAnyQuality) {
  SLACKWATER_NEEDS_SHARED(shared);
  for (const Mooring& mooring : {rottnest, washington}) {
    const VectorColumn seen = column_of(mooring, shared);
    const UtcTime until = seen.time.back().end;
    for (const auto& [what, how] :
         {std::pair{"as it is", ProductOfIt{}},
          std::pair{"without tide", ProductOfIt{25, 0, 0, 1, 0.1, 1}},
          std::pair{"of the week's mean", ProductOfIt{168, 0, 0, 1, 0.15, 6}},
          std::pair{"late and turned", ProductOfIt{1, 0.7, 10, 0.8, 0.1, 1}},
          std::pair{"smooth, every 3 h", ProductOfIt{5, -0.5, -10, 1.2, 0.12, 3}}}) {
      const MooredInstrumentVerdict verdict =
          calibration::check_instrument(product_of(seen, how), seen, 3000, until);
      EXPECT_EQ(verdict.use, MooredInstrumentUse::used)
          << mooring.file << ' ' << what << verdict.why;
      const auto broken = std::count(verdict.column.status.begin(), verdict.column.status.end(),
                                     SampleStatus::suspect) -
                          std::count(seen.status.begin(), seen.status.end(), SampleStatus::suspect);
      const double noise =
          verdict.errors.noise_m_s.empty()
              ? 0
              : *std::max_element(verdict.errors.noise_m_s.begin(), verdict.errors.noise_m_s.end());
      std::printf("%s, product %s: noise of the worst bin %.3f m/s, %td of %zu values left out%s\n",
                  mooring.file, what, noise, broken, seen.status.size(),
                  verdict.remarks.empty() ? "" : (": " + verdict.remarks.front()).c_str());
      EXPECT_LT(noise, 0.1);
      EXPECT_LE(500 * broken, static_cast<std::ptrdiff_t>(seen.status.size()));
    }
  }
}

TEST(RealInstruments, AreRejectedWithAFaultPutIntoThem) {
  SLACKWATER_NEEDS_SHARED(shared);
  const VectorColumn seen = column_of(washington, shared);
  const VectorColumn product = product_of(seen, {1, 0.3, 5, 0.9, 0.05, 1});
  const UtcTime until = seen.time.back().end;
  for (const auto& [turn, bias] :
       {std::pair{Horizontal{-1, 0}, Horizontal{}}, std::pair{std::polar(1.0, 0.7), Horizontal{}},
        std::pair{Horizontal{1, 0}, Horizontal{0.8, 0}}}) {
    VectorColumn wrong = seen;
    for (Horizontal& value : wrong.value) value = turn * value + bias;
    const MooredInstrumentVerdict verdict =
        calibration::check_instrument(product, wrong, 3000, until);
    EXPECT_EQ(verdict.use, MooredInstrumentUse::rejected);
    std::printf("%s\n", verdict.why.c_str());
  }
}

}  // namespace
}  // namespace slackwater::tests::real_instruments_test
