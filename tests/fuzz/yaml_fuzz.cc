#include <cmath>
#include <string>

#include "fields/base/config.h"
#include "fields/site/site.h"
#include "ingest/copernicus/product.h"
#include "ingest/copernicus/vocabulary.h"
#include "tests/fuzz/fuzz_case.h"
#include "tests/fuzz/scratch_folder.h"

namespace {

using namespace slackwater;

/// Reads every key in every way; each way may refuse it.
void read_everything(const Config& config) {
  for (const std::string& key : config.keys()) {
    fuzz::accepts([&] {
      const double number = config.number(key, {-1e3, 1e3});
      fuzz::claim(number >= -1e3 && number <= 1e3, "a number outside its range");
    });
    fuzz::accepts([&] {
      const int number = config.integer(key, -7, 7);
      fuzz::claim(number >= -7 && number <= 7, "a whole number outside its range");
    });
    fuzz::accepts([&] { static_cast<void>(config.optional_text(key)); });
    fuzz::accepts([&] { static_cast<void>(config.optional_flag(key)); });
    fuzz::accepts([&] { static_cast<void>(config.texts(key)); });
    fuzz::accepts([&] {
      for (const double number : config.numbers(key, {0, 90})) {
        fuzz::claim(number >= 0 && number <= 90, "a number of a list outside its range");
      }
    });
    fuzz::accepts([&] {
      for (const Config& entry : config.children(key)) read_everything(entry);
    });
    fuzz::accepts([&] {
      if (const auto child = config.optional_child(key)) read_everything(*child);
    });
  }
  fuzz::accepts([&] { config.expect_all_read(); });
}

void claim_sound(const Site& site) {
  const auto on_earth = [](const GeoPoint& point) {
    fuzz::claim(std::abs(point.latitude_deg()) <= 90 && point.longitude_deg() >= -180 &&
                    point.longitude_deg() < 180,
                "a point that is not on the globe");
  };
  on_earth(site.point);
  for (const GeoPoint& point : site.columns) on_earth(point);
  for (const TurbinePlace& turbine : site.turbines) on_earth(turbine.point);
  fuzz::claim(!site.id.empty() && site.id.find('/') == std::string::npos,
              "an id that is no file name");
  fuzz::claim(!site.water_depth_m || (*site.water_depth_m >= 1 && *site.water_depth_m <= 11000),
              "a depth out of range");
  fuzz::claim(!site.column_block || site.column_block->every >= 1, "a block that never ends");
  for (int from_deg = 0; site.fetch && from_deg <= 360; ++from_deg)
    fuzz::claim(site.fetch->at_m(from_deg) > 0, "a wind without a fetch");
  static_cast<void>(site.box(0.5));
}

}  // namespace

/// YAML: as a plain configuration, a site, a product descriptor and the vocabulary.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  const bool is_yaml = fuzz::accepts([&] { static_cast<void>(Config::parse(text, "fuzz.yaml")); });
  fuzz::accepts([&] { read_everything(Config::parse(text, "fuzz.yaml")); });
  const bool is_site =
      fuzz::accepts([&] { claim_sound(slackwater::parse_site(text, "fuzz.yaml")); });
  fuzz::claim(is_yaml || !is_site, "a site that is not YAML");
  if (!is_yaml) return 0;
  const auto file = fuzz::scratch_folder().file_of(data, size, "fuzz.yaml");
  fuzz::accepts([&] {
    const auto product = ingest::Product::load(file);
    for (const auto& rule : product.means)
      fuzz::claim(rule.step > Duration::zero() || rule.label == ingest::MeanLabel::utc_month,
                  "a mean over nothing");
  });
  fuzz::accepts([&] { static_cast<void>(ingest::Vocabulary::load(file)); });
  return 0;
}
