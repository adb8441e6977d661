#pragma once
#include <optional>
#include <string>
#include <vector>

#include "api/ask/render/render_view.h"
#include "api/log/detection_log.h"
#include "api/perception/detection.h"

namespace slackwater::api {

/// A find in one picture, taken to the surface that it shows.
struct PlacedFind {
  Detection find;
  std::string surface;           ///< "A01/monopile"
  twin::Triple<double> place_m;  ///< NED of the run
  double range_m = 0;
  double size_m = 0;
  std::size_t finding = 0;  ///< that it belongs to
  /// Of the run: the planted one of its kind that it overlaps most (least_shared_to_be_found).
  std::optional<std::uint32_t> defect;
};

/// A planted defect in one picture.
struct ShownDefect {
  std::uint32_t number = 0;  ///< of the run
  std::string of;
  std::string surface;
  double size_m = 0;
  PixelBox box;
  std::size_t pixels = 0;
};

/// What a detector makes of one picture of a run, and the truth of it.
struct DetectedPicture {
  double t_s = 0;  ///< since the start of the run
  UtcTime time;
  int wide = 0;
  int high = 0;
  double range_m = 0;             ///< median over the picture; NaN: nothing within reach
  double gain = 1;                ///< that it was exposed with: above 1 it was dark
  std::vector<PlacedFind> finds;  ///< surest first
  std::vector<ShownDefect> shown;
};

/// A place that is reported: finds of one kind, on one surface, that lie over each other.
struct RunFinding {
  std::string of;
  std::string surface;
  twin::Triple<double> place_m;  ///< NED of the run: of its surest find, like the rest
  double size_m = 0;
  double range_m = 0;
  double confidence = 0;
  UtcTime time;
  std::size_t picture = 0;              ///< that shows it best, by its place
  std::size_t pictures = 0;             ///< that it was found in
  std::size_t last_picture = 0;         ///< of these
  std::optional<std::uint32_t> defect;  ///< nothing: a false alarm
};

/// A run as a detector sees it, picture by picture.
///
/// The middle of a find's box meets a surface; that is its place, and the box's longer side laid
/// along that surface its size (of a crack the diagonal). Range and pose are the true ones, as if a
/// scaling laser and a perfect fix had told them: how well the detector sees is asked here, not how
/// well the vehicle knows where it is. A find whose middle meets nothing is dropped.
///
/// A find belongs to an earlier one of its kind on its surface where they are no farther apart than
/// half of the longer of the two, or `same_place_m`.
class RunFinds {
 public:
  static constexpr std::size_t least_pixels = 25;  // as the labels of `render`
  static constexpr double same_place_m = 0.1;

  /// @param kinds  what the detector can find
  explicit RunFinds(std::vector<std::string> kinds);

  /// The next picture in the order of time. @param view  of a camera
  void add(const RenderView& view, const std::vector<Detection>& found);

  [[nodiscard]] const std::vector<DetectedPicture>& pictures() const noexcept { return pictures_; }
  [[nodiscard]] const std::vector<RunFinding>& findings() const noexcept { return findings_; }
  /// In view is what some picture shows by at least `least_pixels`.
  [[nodiscard]] std::vector<KindFound> score() const;

 private:
  /// @return the finding that it belongs to
  std::size_t join(const PlacedFind& placed);

  std::vector<std::string> kinds_;
  std::vector<DetectedPicture> pictures_;
  std::vector<RunFinding> findings_;
};

}  // namespace slackwater::api
