#pragma once
#include "fields/grid/gridded_field.h"
#include "fields/record/origin.h"

namespace slackwater {

/// The two components of a vector on one grid, cut around a place.
struct VectorPiece {
  Origin origin;
  GriddedField east;
  GriddedField north;
};

/// A scalar on one grid, cut around a place.
struct ScalarPiece {
  Origin origin;
  GriddedField field;
};

}  // namespace slackwater
