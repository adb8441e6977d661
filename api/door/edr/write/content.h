#pragma once
#include <span>
#include <string_view>

namespace slackwater::api::edr {

/// What an answer can be written as.
enum class Format { coverage_json, geojson, csv, netcdf, json, html };

/// The name in `output_formats` and `f`: "CoverageJSON", "GeoJSON", "CSV",
/// "NetCDF", "JSON", "HTML".
[[nodiscard]] std::string_view name_of(Format format) noexcept;
/// "application/prs.coverage+json", ...
[[nodiscard]] std::string_view media_type_of(Format format) noexcept;

/// The format of an answer. `f`, where it is not empty, decides: a name or a media type, in either
/// case; what is not offered is an Error(usage) that lists what is. Else the `Accept` header does
/// (RFC 9110, 12.5.1: wildcards and q weights; the first offered wins a tie); where it accepts
/// nothing that is offered, or is longer than 4 kB, the first offered is served, as 12.4.1 allows.
/// @param offered  not empty, the default first
[[nodiscard]] Format choose_format(std::string_view f, std::string_view accept,
                                   std::span<const Format> offered);

}  // namespace slackwater::api::edr
