#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "data/store/store.h"
#include "fields/base/local_time.h"
#include "fields/service/field.h"
#include "fields/site/chart_datum.h"

namespace slackwater::api {

/// What `slackwater profile` found.
struct ProfileAnswer {
  store::ForecastRow row;
  std::shared_ptr<const Field> field;
  GeoPoint point;
  double water_depth_m = 0;  ///< there
  UtcTime time;
  std::optional<TimeZone> time_zone;      ///< of the site: local time beside UTC in tables
  std::optional<ChartDatum> chart_datum;  ///< as the site states it
  std::size_t member = 0;                 ///< the one that was asked for
  std::vector<std::string> notes;         ///< newer forecasts that are damaged and were passed over
  std::vector<double> depth_m;
  std::vector<CurrentSample> central;               ///< one per depth; the quantiles come from here
  std::vector<CurrentSample> samples;               ///< of the member that was asked for
  std::vector<std::vector<CurrentSample>> members;  ///< of all, by number, if all were asked for
};

/// Writes the answer to standard output: schema in docs/json.md, a spreadsheet, a table for people.
/// The quantiles are those of the forecast, whichever member is shown beside them.
void print_profile_json(const ProfileAnswer& answer);
void print_profile_table(const ProfileAnswer& answer);
/// Many times of one place and forecast, at least one.
void print_profiles_json(const std::vector<ProfileAnswer>& answers);
void print_profiles_csv(const std::vector<ProfileAnswer>& answers);
void print_profiles_table(const std::vector<ProfileAnswer>& answers);

}  // namespace slackwater::api
