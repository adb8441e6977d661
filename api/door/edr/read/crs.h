#pragma once
#include <array>
#include <string_view>

namespace slackwater::api::edr {

/// The identifier of the one reference system that we read and answer in: WGS 84, longitude before
/// latitude.
constexpr std::string_view crs84_uri = "http://www.opengis.net/def/crs/OGC/1.3/CRS84";

/// The names that collections and the OpenAPI document list.
[[nodiscard]] constexpr std::array<std::string_view, 3> crs_names() noexcept {
  return {"CRS84", "EPSG:4326", crs84_uri};
}

/// Accepts `crs` where it names CRS84 or WGS 84: CRS84, OGC:CRS84, EPSG:4326, WGS84, the http(s)
/// URIs and urn:ogc:def:crs forms of these, in either case. Throws Error(usage) that lists what is
/// supported for anything else.
///
/// Coordinates are longitude, latitude under every one of these names, as EDR 1.1 has it
/// (/req/edr/coords-response C spells WGS 84 longitude/latitude out as EPSG 4326); the axis order
/// of the EPSG register is not applied.
void expect_supported_crs(std::string_view text);

}  // namespace slackwater::api::edr
