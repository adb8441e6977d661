#pragma once
#include <vector>

#include "fields/interpolate/temporal.h"
#include "fields/record/choose.h"
#include "fields/record/record.h"
#include "fields/service/snapshot.h"

/// What forecasts of wind and waves are held against.
namespace slackwater::calibration {

/// A moored instrument where there is one, else the analysed product; never a forecast.
/// @param like  Choice::like
template <typename T>
[[nodiscard]] Chosen<T> surface_truth(const Record<T>& record, const Knowledge& knowledge = {},
                                      const std::vector<Stretch>* like = nullptr) {
  Record<T> known;
  for (const auto& piece : record.pieces) {
    if (piece.origin->status != DataStatus::forecast) known.pieces.push_back(piece);
  }
  Choice series;
  series.only_series = true;
  series.like = like;
  Chosen<T> chosen = choose(known, knowledge, series);
  if (!chosen.empty()) return chosen;
  Choice grids;
  grids.only_grids = true;
  grids.like = like;
  return choose(known, knowledge, grids);
}

/// Whether the value of a forecast at a time is the later analysis itself.
/// @param source  of the forecast, per stamp
[[nodiscard]] inline bool is_its_own_truth(const std::vector<UtcTime>& stamps,
                                           const std::vector<DataStatus>& source, UtcTime time,
                                           const Origin& truth) {
  if (truth.is_point_series) return false;
  const auto place = place_in(stamps, time);
  return place && place->low < source.size() && source[place->low] == DataStatus::analysis;
}

}  // namespace slackwater::calibration
