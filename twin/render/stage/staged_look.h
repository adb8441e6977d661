#pragma once
#include <memory>
#include <vector>

#include "twin/inspection/instrument/look.h"
#include "twin/render/frame/pinhole.h"
#include "twin/render/frame/truth_frame.h"
#include "twin/render/lens/picture.h"
#include "twin/render/stage/look_stage.h"

namespace slackwater::twin {

/// A planted defect of a look, with how well the inspection would say that its place is seen.
struct StagedDefect {
  DefectKind kind{};
  std::size_t thing = 0;              ///< of the look, by its place
  Triple<double> centre_m;            ///< NED of the stage
  std::array<double, 2> centre_px{};  ///< from the left and the upper edge
  double size_m = 0;                  ///< longest side
  double width_m = 0;                 ///< shortest side
  LookQuality quality;     ///< of its centre, by the sensor (quality.h); detail infinite: not seen
  std::size_t pixels = 0;  ///< that show it
  double signal_to_noise = 0;  ///< of the picture with it: told_from_noise.h
};

/// One look at a stage: what was drawn, what is seen, and what is there.
struct StagedLook {
  std::uint64_t number = 0;
  Pose pose;
  double range_m = 0;  ///< to the place looked at
  double off_square_rad = 0;
  double depth_m = 0;  ///< of the place looked at, positive down
  double visibility_m = 0;
  double daylight = 0;
  double lamps = 0;
  double growth = 0;
  std::string water;
  std::vector<StagedDefect> defects;
  TruthFrame truth;
  Picture picture;
  std::array<double, 9> matrix{};
  double seen_m2 = 0;  ///< surface in view (seen_area.h)
};

/// A stage, made ready once. A look rests on (stage, seed, its number) alone, bit for bit: looks
/// may be made in any order, in any number, on any number of threads.
///
///  1. A place of a surface is drawn, each square metre as likely; then how far off, how far from
///     square, round which side and how rolled the camera looks at it, as often as it takes for the
///     place to be the first thing in its way, in the sensor's medium.
///  2. Visibility, daylight, lamps, growth, water and the seed of materials are drawn.
///  3. Defects are planted where pixels drawn from the picture meet a surface that may have them,
///     none within the size of another; how they lie and how wide they are is as in any run
///     (`mark_of`).
///
/// The quality beside each defect is the inspection's, by the instrument that it would have of the
/// camera (camera_instrument.h). Behind the surfaces is open water or sky: no sea, no bed but what
/// the stage lists.
class Stage {
 public:
  explicit Stage(LookStage stage);
  ~Stage();
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  [[nodiscard]] const LookStage& sheet() const noexcept;
  /// By their place: what the pictures' numbers less 1 stand for.
  [[nodiscard]] const std::vector<SeenThing>& things() const noexcept;
  /// @throws Error(invalid_input) where a thousand draws find no place that can be looked at: the
  ///         ranges leave none
  [[nodiscard]] StagedLook look(std::uint64_t seed, std::uint64_t number, int threads) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace slackwater::twin
