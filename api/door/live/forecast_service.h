#pragma once
#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "api/door/dds/participant.h"
#include "api/door/live/topics/stream.h"
#include "api/door/live/topics/water_publisher.h"
#include "api/issued/issued_fields.h"

namespace slackwater::live {

/// The forecasts in force of a store on DDS, without any run: the water of each site as forecast
/// for now, and `/slackwater/query_profile` for any place and time that one of them reaches. A new
/// forecast is told of within seconds. On a thread of its own.
class ForecastService {
 public:
  /// @param now         the clock on the wall
  /// @param on_trouble  of forecasts that are over, once for each; from any thread
  /// @throws Error(invalid_input), Error(unavailable) as `dds::Participant` does
  ForecastService(const dds::DomainSettings& domain, std::shared_ptr<api::IssuedFields> forecasts,
                  std::function<UtcTime()> now);
  ~ForecastService();
  ForecastService(const ForecastService&) = delete;
  ForecastService& operator=(const ForecastService&) = delete;

 private:
  struct Site {
    WaterPublisher voice;
    std::string instance;  ///< told of last
    bool is_over = false;  ///< was said of it
  };
  void tell_all();
  void tell(const api::ForecastCatalogue::SiteForecast& forecast);
  void run();

  std::shared_ptr<api::IssuedFields> forecasts_;
  std::function<UtcTime()> now_;
  std::function<void(const std::string&)> on_trouble_;
  dds::Participant participant_;
  Stream stream_;
  std::map<std::string, Site> sites_;  ///< by their ids
  UtcTime begun_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace slackwater::live
