#include "fields/site/write_site.h"

#include <gtest/gtest.h>

namespace slackwater::tests::write_site_test {
namespace {

Site new_site() {
  Site site;
  site.id = "parc_nord";
  site.name = "Parc Nord";
  site.point = GeoPoint::from_degrees(54.05, 6.45);
  return site;
}

TEST(WriteSite, IsTheFileThatPeopleGoOnWith) {
  Site site = new_site();
  EXPECT_EQ(new_site_yaml(site, ""),
            "id: parc_nord\nname: \"Parc Nord\"\nlatitude_deg: 54.05\nlongitude_deg: 6.45\n"
            "# water_depth_m: 35  # not known: no bathymetry is stored for this place\n");
  site.water_depth_m = 30;
  site.time_zone = TimeZone::named("Europe/Berlin");
  EXPECT_EQ(new_site_yaml(site, "as given"),
            "id: parc_nord\nname: \"Parc Nord\"\nlatitude_deg: 54.05\nlongitude_deg: 6.45\n"
            "water_depth_m: 30.0  # as given\ntimezone: Europe/Berlin\n");
}

TEST(WriteSite, WhatIsWrittenIsReadAsItWasWhateverItsName) {
  for (const char* id : {"a", "null", "true", "1e5", "0x1", "-", "a.b-c_d"})
    for (const char* name : {"Parc éolien, bloc 2", "\"", "a: b # c", "null", "\n- x", "\\", ""}) {
      Site site = new_site();
      site.id = id;
      site.name = name;
      site.point = GeoPoint::from_degrees(-54.123412, -179.123412);
      site.water_depth_m = 12.34;
      site.time_zone = TimeZone::named("America/New_York");
      const std::string yaml = new_site_yaml(site, "as given");
      const Site read = parse_site(yaml, "new.yaml");
      EXPECT_EQ(read.id, site.id) << yaml;
      EXPECT_EQ(read.name, site.name) << yaml;
      // Six digits of degrees, seven of longitudes.
      EXPECT_NEAR(read.point.latitude_deg(), site.point.latitude_deg(), 0.5e-4) << yaml;
      EXPECT_NEAR(read.point.longitude_deg(), site.point.longitude_deg(), 0.5e-4) << yaml;
      EXPECT_NEAR(read.water_depth_m.value(), 12.34, 0.05 + 1e-9) << yaml;
      EXPECT_EQ(read.time_zone.value().name(), "America/New_York") << yaml;
      EXPECT_TRUE(read.columns.empty() && read.tasks.empty());
    }
}

}  // namespace
}  // namespace slackwater::tests::write_site_test
