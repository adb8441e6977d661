#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "fields/base/time.h"
#include "twin/inspection/instrument/look.h"
#include "twin/render/frame/stereo.h"
#include "twin/render/frame/truth_frame.h"
#include "twin/render/lens/picture.h"
#include "twin/render/light/infrared_frame.h"
#include "twin/render/sheet/render_sensor.h"

namespace slackwater::api {

/// What a scene's numbers stand for.
struct SeenName {
  std::string name;
  twin::SeenClass seen_class{};
};

/// A defect that is in the scene, in view or not.
struct SeenDefect {
  std::uint32_t number = 0;  ///< of the run
  twin::DefectKind kind{};
  std::string surface;
  std::size_t thing = 0;  ///< its number, from 1
  double size_m = 0;
  double severity = 0;
  twin::Triple<double> centre_m;  ///< NED of the run
  std::size_t pixels = 0;         ///< of this picture that show it
};

/// The right one of a pair of cameras.
struct RightView {
  double baseline_m = 0;
  twin::Picture picture;
  twin::StereoTruth truth;  ///< of the left picture
};

struct CameraView {
  twin::TruthFrame truth;
  twin::Picture picture;
  std::array<double, 9> matrix{};  ///< camera matrix, row by row
  std::size_t flakes = 0;          ///< of marine snow, in view or behind something
  std::size_t drops = 0;           ///< of spray, likewise
  std::optional<RightView> right;  ///< of a pair: what is said here is of the left one
};

struct InfraredView {
  twin::TruthFrame truth;
  twin::InfraredFrame heat;
  std::array<double, 9> matrix{};  ///< camera matrix, row by row
};

struct MultibeamView {
  std::vector<twin::Sounding> soundings;  ///< by beam, from port to starboard
};

/// What a sensor saw, by what it is.
using SeenByDevice =
    std::variant<CameraView, InfraredView, twin::LidarScan, twin::SonarImage, twin::SideScanPing,
                 MultibeamView, twin::EchoSounding, twin::CurrentProfile>;

/// What the sensor saw at one moment.
struct RenderView {
  double t_s = 0;  ///< since the start of the run
  UtcTime time;
  twin::Pose pose;                  ///< of the sensor, NED of the run
  std::vector<SeenName> things;     ///< by their number, from 1
  std::vector<SeenDefect> defects;  ///< by their number in the picture, from 1
  SeenByDevice seen;
};

}  // namespace slackwater::api
