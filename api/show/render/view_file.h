#pragma once
#include <filesystem>

#include "api/ask/render/rendered_run.h"

namespace slackwater::api {

/// A view as a picture to look at: a camera's colours; of a lidar its ranges, near bright, channels
/// from the highest down; of a sonar its echoes in decibels, 60 of them from black to white, beams
/// from left to right, near below. @throws Error(unavailable)
void write_view_png(const RenderView& view, const std::filesystem::path& file);

/// The picture of the right one of a pair of cameras; nothing where there is none.
/// @return whether there is one
bool write_right_png(const RenderView& view, const std::filesystem::path& file);

/// A view with its truth, as netCDF-4: of a camera range, depth, instance, class, defect and
/// normal of each pixel; of a lidar ranges as told and as they are; of a sonar echoes with speckle
/// and without. With the camera matrix, where the sensor was (x east, y north, z up of the run's
/// origin) and how it was turned, the names of things, and the defects of the scene; of a pair of
/// cameras the disparity, and what both see. The same view
/// is the same bytes. Whole or not at all. @throws Error(unavailable)
void write_view_netcdf(const RenderView& view, const RenderedRun& run,
                       const std::filesystem::path& file);

}  // namespace slackwater::api
