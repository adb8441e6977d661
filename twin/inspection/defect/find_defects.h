#pragma once
#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "twin/inspection/defect/detection_method.h"
#include "twin/inspection/defect/measure.h"
#include "twin/inspection/instrument/look.h"

namespace slackwater::twin {

/// The best looks of one instrument at one surface.
struct SurfaceLooks {
  std::size_t surface = 0;  ///< of the plan
  std::string name;         ///< of the instrument in the run, "rov1/camera": one each
  const Instrument* instrument = nullptr;
  std::span<const BestLook> looks;  ///< one for each patch
  /// Pictures worse than this are not read for false alarms: what the plan asks for.
  double most_detail_m = std::numeric_limits<double>::infinity();
};

/// What was reported. The truth stands beside it.
struct Finding {
  std::optional<std::uint32_t> defect;  ///< its number; nothing: a false alarm
  DefectKind kind{};
  std::size_t surface = 0;
  std::size_t patch = 0;
  Triple<double> position_m;  ///< NED, as reported: off by what the vehicle's position was off
  Triple<double> true_position_m;
  double size_m = 0;               ///< as measured
  double true_size_m = 0;          ///< 0: nothing is there
  std::optional<double> severity;  ///< as measured, where the instrument measures it
  double true_severity = 0;
  std::optional<Reading> reading;  ///< from which the severity was had
  std::string instrument;          ///< of the run
  std::string method;              ///< whose curve
  double t_s = 0;                  ///< of the look that shows it, since the epoch
  double detail_m = 0;
  double probability = 0;  ///< of being found; of a false alarm 0
};

enum class MissReason {
  nothing_finds_it,  ///< no instrument of the run could
  not_seen,
  seen_too_poorly,  ///< the same chance with the detail of the curve would have found it
  overlooked,       ///< by chance, though seen well enough
};
struct Miss {
  Defect defect;
  MissReason reason{};
  std::string words;
  /// The least over the instruments that could have found it; infinite: not seen.
  double detail_m = std::numeric_limits<double>::infinity();
};

struct Findings {
  std::vector<Finding> found;  ///< by defect, then by instrument; then the false alarms
  std::vector<Miss> missed;    ///< by no instrument at all
  double read_m2 = 0;          ///< area of the patches that were read for at least one method
};

/// What comes of the best looks. A pure function of its arguments: each defect has one uniform
/// number u for each instrument, and is found by it where POD >= u. So a better look never loses
/// what a worse one found, and looking again does not throw the dice again. False alarms: each
/// patch that was read has a Poisson number of them for each method, by its area.
///
/// A measured size is never below 0. The place of a defect is the centre of its patch.
/// @param looks  names and surfaces not twice; looks as many as the surface has patches
/// @throws Error(invalid_input) where an instrument's unit is not that of what it measures, or two
///         methods find the same
[[nodiscard]] Findings find_defects(std::span<const Defect> defects,
                                    std::span<const Surface> surfaces,
                                    std::span<const SurfaceLooks> looks,
                                    const std::vector<DetectionMethod>& methods,
                                    const DefectFacts& facts, std::uint64_t seed);

}  // namespace slackwater::twin
