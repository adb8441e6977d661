#include "api/door/edr/read/crs.h"

#include <algorithm>
#include <array>
#include <string>

#include "api/door/edr/read/bad_parameter.h"

namespace slackwater::api::edr {
namespace {

constexpr std::size_t max_crs_bytes = 256;

constexpr std::array<std::string_view, 12> names{"crs84",
                                                 "ogc:crs84",
                                                 "epsg:4326",
                                                 "4326",
                                                 "wgs84",
                                                 "http://www.opengis.net/def/crs/ogc/1.3/crs84",
                                                 "https://www.opengis.net/def/crs/ogc/1.3/crs84",
                                                 "http://www.opengis.net/def/crs/epsg/0/4326",
                                                 "https://www.opengis.net/def/crs/epsg/0/4326",
                                                 "urn:ogc:def:crs:ogc:1.3:crs84",
                                                 "urn:ogc:def:crs:ogc::crs84",
                                                 "urn:ogc:def:crs:epsg::4326"};

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

void expect_supported_crs(std::string_view text) {
  expect_short("crs", text, max_crs_bytes);
  std::string name(text);
  std::transform(name.begin(), name.end(), name.begin(), lower);
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  throw bad_parameter(
      "crs", text,
      "CRS84 (" + std::string(crs84_uri) + ") or EPSG:4326, both with longitude before latitude");
}

}  // namespace slackwater::api::edr
