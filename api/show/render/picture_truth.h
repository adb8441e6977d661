#pragma once
#include <array>
#include <span>

#include "api/ask/render/render_view.h"
#include "api/show/render/view_variables.h"

namespace slackwater::api {

/// What is there in a picture.
struct PictureTruth {
  const twin::TruthFrame& frame;
  const std::array<double, 9>& matrix;  ///< of the camera, row by row
  std::span<const SeenName> things;     ///< by their number, from 1
  std::span<const SeenDefect> defects;  ///< by their number in the picture, from 1
};

/// The truth of a picture in a netCDF file: range, depth, instance, class, defect and normal of
/// each pixel over (row, column), the camera's matrix, and the planted defects of the scene over
/// (planted), in view or not.
class TruthVariables {
 public:
  TruthVariables(ingest::netcdf::Writer& writer, const PictureTruth& truth);
  /// More of each pixel can be added to it.
  [[nodiscard]] ViewVariables& pixels() noexcept { return pixels_; }
  /// Once all of the file is defined.
  void write();

 private:
  ingest::netcdf::Writer& writer_;
  ViewVariables pixels_;
  std::vector<std::pair<int, std::vector<double>>> defects_;
};

}  // namespace slackwater::api
