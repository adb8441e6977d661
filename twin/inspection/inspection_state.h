#pragma once
#include <cstdint>
#include <vector>

#include "twin/inspection/instrument/look.h"

namespace slackwater::twin {

/// How far an inspection has come. Numbers only: they are copied into a checkpoint and back.
struct InspectionState {
  struct Line {
    Pose pose;               ///< of the instrument, at its last look
    Triple<double> place_m;  ///< of the vehicle then, NED
    Triple<double> ahead;    ///< of its bow then, NED
    double range_m = 0;      ///< to the nearest place of its surfaces then
    double looked_s = 0;     ///< when that was, since the epoch
    std::uint64_t looks = 0;
    bool has_looked = false;  ///< since its work began, or went on
  };
  std::vector<Line> lines;
  std::vector<std::vector<BestLook>> best;  ///< of each pair, of each patch
  std::uint64_t seed =
      0;  ///< of the run: for the defects that are there, and what is found of them
  std::uint64_t rays = 0;
  double worked_s = 0;
};
}  // namespace slackwater::twin
