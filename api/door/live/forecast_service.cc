#include "api/door/live/forecast_service.h"

#include "api/door/dds/message/names.h"
#include "api/door/live/profile_answer.h"
#include "api/door/live/topics/dds_outlet.h"

namespace slackwater::live {

ForecastService::ForecastService(const dds::DomainSettings& domain,
                                 std::shared_ptr<api::IssuedFields> forecasts,
                                 std::function<UtcTime()> now)
    : forecasts_(std::move(forecasts)),
      now_(std::move(now)),
      on_trouble_(domain.on_trouble),
      participant_(domain),
      begun_(now_()) {
  stream_.add(std::make_shared<DdsOutlet>(participant_));
  participant_.serve(
      {"/slackwater/query_profile", "slackwater_msgs/srv/QueryProfile"},
      [this](dds::Payload request, const std::string&, const dds::Answer& answer) {
        try {
          const dds::ProfileAsked asked = dds::read_query_profile(request);
          const auto catalogue = forecasts_->catalogue();
          const auto* site = is_on_earth(asked)
                                 ? catalogue->site_at(asked.longitude_deg, asked.latitude_deg)
                                 : nullptr;
          answer(profile_answer(site == nullptr ? nullptr : site->field.get(), 0, asked));
        } catch (const std::exception& e) {
          answer(dds::profile_refusal(e.what()));
        }
      });
  participant_.announce();
  thread_ = std::thread([this] { run(); });
}

ForecastService::~ForecastService() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void ForecastService::run() {
  std::unique_lock lock(mutex_);
  while (!ends_) {
    try {
      tell_all();
    } catch (const std::exception& e) {
      if (on_trouble_) on_trouble_(std::string("forecasts on DDS: ") + e.what());
    }
    wake_.wait_for(lock, std::chrono::seconds(1), [&] { return ends_; });
  }
}

void ForecastService::tell_all() {
  const auto catalogue = forecasts_->catalogue();
  for (const auto& forecast : catalogue->sites) tell(forecast);
}

void ForecastService::tell(const api::ForecastCatalogue::SiteForecast& forecast) {
  auto found = sites_.find(forecast.site_id);
  if (found == sites_.end()) {
    found = sites_
                .emplace(forecast.site_id,
                         Site{WaterPublisher(stream_, dds::ros_token(forecast.site_id)), {}})
                .first;
    stream_.opened();
  }
  Site& site = found->second;
  if (site.instance != forecast.instance) {
    site.instance = forecast.instance;
    site.is_over = false;
    site.voice.renew();
  }
  const UtcTime now = now_();
  const Field& field = *forecast.field;
  if (now < field.range().from || now > field.range().to) {
    if (!std::exchange(site.is_over, true) && on_trouble_) {
      on_trouble_(forecast.instance + " says nothing of now; " + field.range().text() +
                  "; nothing is published for " + forecast.site_id +
                  " until a newer one is issued");
    }
    return;
  }
  const GeoPoint& point = field.snapshot().columns.front().point;
  const Place place{point.longitude_deg(), point.latitude_deg(), 0, now};
  SeaSample sea;
  field.sample_sea({&place, 1}, {&sea, 1});
  site.voice.speak({field, 0, point}, sea, dds::stamp_of(now, 0), seconds_between(begun_, now));
}

}  // namespace slackwater::live
