#include "tests/api/door/edr/made_up_store.h"

#include "tests/api/issued/commit_made_up.h"
#include "tests/support/made_up_forecast.h"

namespace slackwater::tests {
namespace {

Snapshot small_forecast(const std::string& site, std::size_t columns, std::uint64_t seed) {
  MadeUpForecast size;
  size.columns = columns;
  size.hours = 12;
  size.members = 3;
  size.seed = seed;
  Snapshot made = made_up_forecast(size);
  made.site_id = site;
  made.site_name = "Site " + site;
  add_made_up_level(made);
  return made;
}

Snapshot farm_forecast() {
  Snapshot made = small_forecast("farm", 12, 21);
  for (std::size_t c = 0; c < made.columns.size(); ++c) {
    made.columns[c].point = GeoPoint::from_degrees(57.20 + 0.02 * static_cast<double>(c / 4),
                                                   2.40 + 0.02 * static_cast<double>(c % 4));
  }
  return made;
}

Snapshot dateline_forecast() {
  Snapshot made = small_forecast("dateline", 2, 31);
  made.columns[0].point = GeoPoint::from_degrees(-17, 179.99);
  made.columns[1].point = GeoPoint::from_degrees(-17, -179.99);
  return made;
}

}  // namespace

Snapshot lone_forecast(int days_later, std::uint64_t seed) {
  Snapshot made = small_forecast("lone", 1, seed);
  const auto later = std::chrono::days(days_later);
  made.day += later;
  made.issued += later;
  for (UtcTime& time : made.time) time += later;
  return made;
}

void commit_made_up_forecast(const std::filesystem::path& folder, const Snapshot& made) {
  store::Store store = store::Store::open(folder, store::OpenMode::create_or_write);
  commit_made_up(store, made);
}

void fill_with_made_up_forecasts(const std::filesystem::path& folder) {
  for (const Snapshot& made :
       {lone_forecast(0, 11), lone_forecast(1, 12), farm_forecast(), dateline_forecast()})
    commit_made_up_forecast(folder, made);
}

}  // namespace slackwater::tests
