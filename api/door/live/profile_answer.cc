#include "api/door/live/profile_answer.h"

#include "fields/base/text.h"

namespace slackwater::live {

bool is_on_earth(const dds::ProfileAsked& asked) noexcept {
  const auto is_within = [](double value, double most) { return value >= -most && value <= most; };
  return is_within(asked.latitude_deg, 90) && is_within(asked.longitude_deg, 360);
}

dds::Bytes profile_answer(const Field* field, std::size_t member, const dds::ProfileAsked& asked) {
  if (!is_on_earth(asked)) {
    return dds::profile_refusal(
        formatted("found {:g} N, {:g} E; expected a latitude from -90 to 90 and a longitude from "
                  "-360 to 360 degrees",
                  asked.latitude_deg, asked.longitude_deg));
  }
  if (field == nullptr) {
    return dds::profile_refusal(formatted("no forecast reaches {:g} N, {:g} E; ask near a site",
                                          asked.latitude_deg, asked.longitude_deg));
  }
  const UtcTime time = dds::time_of(asked.time);
  const Place place{asked.longitude_deg, asked.latitude_deg, 0, time};
  if (const CurrentSample top = field->current(place); !has_value(top.status)) {
    return dds::profile_refusal("no current at this place and time (" +
                                std::string(name_of(top.status)) + "); " + field->range().text());
  }
  const GeoPoint at = GeoPoint::from_degrees(asked.latitude_deg, asked.longitude_deg);
  return dds::profile_reply({*field, member, at}, time, asked.time);
}

}  // namespace slackwater::live
