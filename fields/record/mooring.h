#pragma once
#include <vector>

#include "fields/record/piece.h"

namespace slackwater {

/// Joins the current series of one mooring into one piece: files of one depth each, months in files
/// of their own, profilers that look up and down from the same line.
///
/// One mooring are point series at most 500 m apart (a mooring is laid anew near its place, not on
/// it), of one status, all of instants or all of means. The piece has every time and every level of
/// its parts; levels nearer than a quarter of the finest spacing (25 cm at most) are one. Where two
/// parts have a value at one time and level, the later ingested wins. What has no value anywhere is
/// `missing`. The order of pieces is kept, a joined piece stands where its first part stood.
void join_moorings(std::vector<VectorPiece>& pieces);

}  // namespace slackwater
