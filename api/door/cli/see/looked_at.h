#pragma once
#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "api/ask/detect/run_finds.h"
#include "api/ask/render/rendered_run.h"
#include "api/perception/detector.h"
#include "api/show/detect/seen_page.h"

namespace slackwater::api {

/// What a detector makes of a run's pictures, as they come, and how that is told.
class LookedAt {
 public:
  /// @param by              a detector: load_detector
  /// @param sensor          its name
  /// @param keeps_pictures  for the page
  /// @throws Error(usage) where the sensor is no camera
  LookedAt(const std::string& by, const RenderedRun& run, const std::string& sensor,
           bool keeps_pictures);

  /// The next picture in the order of time. @return what was found in it
  std::vector<Detection> add(const RenderView& view);

  /// Puts what was found into the log of the run, in place of what the same detector found in
  /// pictures of the same sensor before. @throws Error(unavailable); the log is then as it was
  void record_in(const std::filesystem::path& log) const;

  [[nodiscard]] std::string words() const;
  [[nodiscard]] nlohmann::json json() const;
  /// Only where it keeps pictures.
  [[nodiscard]] std::string page() const;
  /// @param shows_truth  whether there is something
  [[nodiscard]] std::string geojson(bool shows_truth) const;

 private:
  std::unique_ptr<Detector> detector_;
  RunFinds finds_;
  WhoLooked who_;
  std::string title_;
  bool keeps_pictures_ = false;
  std::vector<Thumbnail> thumbnails_;
};

}  // namespace slackwater::api
