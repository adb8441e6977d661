// Issued forecasts on DDS, without any run.
#include "api/door/live/forecast_service.h"

#include <gtest/gtest.h>

#include <atomic>

#include "api/door/live/profile_answer.h"
#include "tests/api/door/dds/own_domain.h"
#include "tests/api/door/edr/made_up_store.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::forecast_service_test {
namespace {

using namespace std::chrono_literals;

/// What was heard last on a latched topic.
class Ear {
 public:
  Ear(dds::Participant& participant, const std::string& topic, const std::string& type) {
    participant.subscribe({topic, type, "", {true, true, 1}},
                          [this](dds::Payload message, const std::string&) {
                            const std::lock_guard lock(mutex_);
                            heard_.assign(message.begin(), message.end());
                          });
  }
  [[nodiscard]] dds::Bytes heard_within(std::chrono::seconds time, const dds::Bytes& other_than) {
    const auto until = std::chrono::steady_clock::now() + time;
    while (std::chrono::steady_clock::now() < until) {
      {
        const std::lock_guard lock(mutex_);
        if (!heard_.empty() && heard_ != other_than) return heard_;
      }
      std::this_thread::sleep_for(5ms);
    }
    return {};
  }

 private:
  std::mutex mutex_;
  dds::Bytes heard_;
};

dds::DomainSettings loopback(int domain) {
  dds::DomainSettings settings;
  settings.domain = domain;
  settings.is_loopback_only = true;
  return settings;
}

dds::Bytes profile_at(const Field& field, UtcTime time) {
  return dds::current_profile({field, 0, field.snapshot().columns.front().point}, time,
                              dds::stamp_of(time, 0));
}

TEST(ForecastService, TellsOfTheWaterNowAndOfEachNewForecast) {
  const TemporaryFolder folder;
  commit_made_up_forecast(folder / "store", lone_forecast(0, 1));
  const auto forecasts = std::make_shared<api::IssuedFields>(folder / "store", 50ms);
  const auto first = forecasts->catalogue()->sites.at(0).field;
  std::atomic<UtcTime> now = first->range().from + std::chrono::hours(3);
  const OwnDomain domain;
  std::mutex mutex;
  std::vector<std::string> told;
  dds::DomainSettings settings = loopback(domain.number());
  settings.on_trouble = [&](const std::string& text) {
    const std::lock_guard lock(mutex);
    told.push_back(text);
  };
  const live::ForecastService service(settings, forecasts, [&] { return now.load(); });
  dds::Participant client(loopback(domain.number()));
  Ear profile(client, "/lone/current_profile", "slackwater_msgs/msg/CurrentProfile");
  Ear wave(client, "/lone/wave", "slackwater_msgs/msg/SeaState");
  const dds::Bytes heard = profile.heard_within(20s, {});
  EXPECT_EQ(heard, profile_at(*first, now));
  EXPECT_FALSE(wave.heard_within(20s, {}).empty());
  // The next forecast, issued by another process.
  commit_made_up_forecast(folder / "store", lone_forecast(1, 2));
  now = now.load() + std::chrono::hours(24);
  const dds::Bytes later = profile.heard_within(20s, heard);
  const auto second = forecasts->catalogue()->sites.at(0).field;
  EXPECT_EQ(later, profile_at(*second, now));
  // Days later nobody knows anything: that is said once, and nothing is told.
  now = now.load() + std::chrono::hours(240);
  const auto has_told = [&] {
    const std::lock_guard lock(mutex);
    return std::any_of(told.begin(), told.end(), [](const std::string& text) {
      return text.find("nothing is published for lone until a newer one is issued") !=
             std::string::npos;
    });
  };
  for (int i = 0; i < 2000 && !has_told(); ++i) std::this_thread::sleep_for(10ms);
  EXPECT_TRUE(has_told());
  EXPECT_TRUE(profile.heard_within(2s, later).empty());
}

TEST(ProfileAnswer, SaysWhyThereIsNone) {
  const Field field(std::make_shared<const Snapshot>(lone_forecast(0, 1)));
  const GeoPoint& at = field.snapshot().columns.front().point;
  const dds::Stamp then = dds::stamp_of(field.range().from, 3600);
  const auto text = [](const dds::Bytes& reply) { return std::string(reply.begin(), reply.end()); };
  const auto has = [&](const dds::Bytes& reply, const char* part) {
    return reply[4] == 0 && text(reply).find(part) != std::string::npos;
  };
  const double latitude = at.latitude_deg(), longitude = at.longitude_deg();
  EXPECT_EQ(live::profile_answer(&field, 0, {latitude, longitude, then})[4], 1) << "success";
  EXPECT_TRUE(has(live::profile_answer(&field, 0, {91, longitude, then}),
                  "expected a latitude from -90 to 90"));
  EXPECT_TRUE(has(live::profile_answer(nullptr, 0, {10, 10, then}), "no forecast reaches"));
  EXPECT_TRUE(
      has(live::profile_answer(&field, 0, {latitude, longitude, {}}), field.range().text().c_str()))
      << "1970, with what there is";
}

}  // namespace
}  // namespace slackwater::tests::forecast_service_test
