#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "api/ask/render/render_view.h"
#include "api/ask/render/sight_choice.h"
#include "fields/base/time.h"
#include "fields/geo/geo_point.h"

namespace slackwater::api {

/// A sensor on a vehicle of a run that is over.
struct RenderChoice {
  std::filesystem::path log;
  std::string sensor;   ///< of data/sensors
  std::string vehicle;  ///< empty: the only one, or the first that the sensor's medium suits
  SightChoice sight;
  int threads = 1;
  std::optional<std::filesystem::path> forecast;  ///< of its water, where not in the store
};

/// A run that is over, looked at again: its log, scenario, water and what is inspected, made ready
/// once; any number of moments after that. What is seen at a moment rests on the log, the data
/// folder and the choice alone, bit for bit, whatever the number of threads.
class RenderedRun {
 public:
  /// @throws Error(not_found), Error(invalid_input) for what is no log or has no scenario, a
  ///         vehicle or a sensor that is not there, a forecast that is gone
  RenderedRun(const RenderChoice& choice, const std::filesystem::path& store_folder);
  ~RenderedRun();
  RenderedRun(const RenderedRun&) = delete;
  RenderedRun& operator=(const RenderedRun&) = delete;

  [[nodiscard]] const twin::RenderSensor& sensor() const noexcept;
  [[nodiscard]] const std::string& vehicle() const noexcept;
  [[nodiscard]] const std::string& title() const noexcept;  ///< of the run
  [[nodiscard]] GeoPoint origin() const noexcept;
  [[nodiscard]] UtcTime start() const noexcept;
  [[nodiscard]] double from_s() const noexcept;  ///< of the log's rows
  [[nodiscard]] double to_s() const noexcept;
  /// What is left out or assumed, for people.
  [[nodiscard]] const std::vector<std::string>& warnings() const noexcept;

  /// Between two rows of the log the vehicles are on the straight way.
  /// @throws Error(invalid_input) for a time outside the log, a vehicle that was not there then, a
  ///         sensor outside its medium
  [[nodiscard]] RenderView view_at(double t_s) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace slackwater::api
