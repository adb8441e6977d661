#pragma once
#include <cstdint>
#include <span>

#include "twin/clearance/handling.h"
#include "twin/scene/structure.h"
#include "twin/tether/tether.h"

namespace slackwater::twin {

/// How much water there is to be between hulls, at least. The defaults are estimates, an operator's
/// choice: lengths of the larger hull, of a grab, of a propeller's draught.
struct StandOff {
  double craft_m = 10;     ///< from vehicles of the run
  double structure_m = 3;  ///< from what stands in the water
  double tether_m = 2;     ///< from lines
  double vessel_m = 100;   ///< from traffic that keeps its course
  double vertical_m = 5;   ///< above or below any of them, where that is what keeps clear
  bool operator==(const StandOff&) const = default;
};

/// A vehicle of the run as the others know it: as of the last barrier.
struct Craft {
  Claim claim;
  Planar position_m;
  Planar velocity_m_s;
  Planar wish_m;                    ///< where it would go within its stopping way
  std::ptrdiff_t hindered_by = -1;  ///< the vehicle that keeps it from there, or nobody
  double radius_m = 0;              ///< its own, without that of a circle
  bool is_leaving = false;          ///< the way of a vessel: all others make room for it
  bool obeys = true;                ///< keeps to the same rule, and has not halted
  bool keeps_level = false;         ///< afloat
  bool is_there = true;             ///< not aboard another
  static constexpr std::ptrdiff_t nobody = -1;
  std::ptrdiff_t carrier = nobody;  ///< by its place in the run: the two come as near as they like
};

/// A line in the water: nodes from its top to the vehicle that it ends at.
struct Line {
  std::span<const Triple<double>, tether_nodes> node_m;
  std::size_t owner = 0;  ///< by its place in the run
  bool is_whole = true;
  std::ptrdiff_t carrier = Craft::nobody;  ///< from whose deck it hangs, which does not keep clear
};

/// A vessel that keeps its course and speed.
struct Passer {
  Planar position_m;
  Planar velocity_m_s;
  double half_length_m = 0;
  double half_beam_m = 0;
  double top_m = 0;  ///< z, of its masts
  double bottom_m = 0;
  std::uint32_t id = 0;    ///< its MMSI; 0: none
  bool is_of_run = false;  ///< a vehicle that does not keep clear
};

/// All that a vehicle keeps clear of. Borrowed for the length of a call.
struct Lookout {
  std::span<const Craft> craft;
  std::size_t own = 0;  ///< among them; their order is the right of way, the first has it
  std::span<const Structure> structures;
  std::span<const Line> lines;
  std::span<const Passer> passers;
  std::span<const std::uint32_t> not_of_concern{};  ///< passers that it does not keep clear of
};

}  // namespace slackwater::twin
