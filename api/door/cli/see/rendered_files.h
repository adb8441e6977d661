#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "api/ask/render/rendered_run.h"
#include "api/show/render/picture_labels.h"
#include "api/show/render/waterfall.h"

namespace slackwater::api {

/// What a sensor saw on a run, as files of a folder: a picture and its truth for each moment, the
/// labels of all, the waterfall of what tells a line at a time. Each file is whole, or not there.
class RenderedFiles {
 public:
  /// Makes the folder where it is not there.
  /// @param run  outlives it
  /// @throws Error(unavailable)
  RenderedFiles(const RenderedRun& run, std::string sensor, std::filesystem::path folder);

  /// The next moment, in the order of time.
  void add(const RenderView& view);
  /// After the last one.
  void finish();

  [[nodiscard]] std::string words() const;
  /// `sensor`, `vehicle`, `folder`, `warnings`, `frames`, and `waterfall` where there is one.
  [[nodiscard]] nlohmann::json json() const;

 private:
  const RenderedRun& run_;
  std::string sensor_;
  std::filesystem::path folder_;
  nlohmann::json frames_ = nlohmann::json::array();
  PictureLabels labels_;
  Waterfall waterfall_;
  std::size_t with_defects_ = 0;
};

/// From the first to the last row of the log.
/// @throws Error(usage) for more moments than anybody looks at
[[nodiscard]] std::vector<double> moments_each(double step_s, const RenderedRun& run,
                                               const std::string& option);

}  // namespace slackwater::api
