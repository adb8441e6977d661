#pragma once
#include <filesystem>

#include "twin/render/stage/staged_look.h"

namespace slackwater::api {

/// The truth of a staged look as netCDF-4 (`TruthVariables`), with where the camera was: the
/// stage's origin stands for a run's. The same look is the same bytes. Whole or not at all.
/// @throws Error(unavailable)
void write_look_netcdf(const twin::StagedLook& look, const twin::Stage& stage,
                       const std::filesystem::path& file);

}  // namespace slackwater::api
