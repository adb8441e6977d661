#pragma once
#include "api/ask/render/rendered_run.h"
#include "ingest/netcdf/file.h"

namespace slackwater::api {

// A ping as netCDF: what was heard, and what was so. After these the file is whole.

/// `intensity`, `mean_intensity` and `instance` over (side, bin): port, then starboard, from near
/// to far.
void write_seen(const twin::SideScanPing& ping, const RenderView& view,
                ingest::netcdf::Writer& writer);
/// By beam from port to starboard: ranges, bearings, echo levels, and the soundings' places as told
/// and as they are.
void write_seen(const MultibeamView& swath, const RenderView& view, ingest::netcdf::Writer& writer);
/// The echo by bin; ranges as told and as they are.
void write_seen(const twin::EchoSounding& sounding, const RenderView& view,
                ingest::netcdf::Writer& writer);
/// By bin: the velocity of the water as told and as it is, and what each beam heard.
void write_seen(const twin::CurrentProfile& profile, const RenderView& view,
                ingest::netcdf::Writer& writer);

}  // namespace slackwater::api
