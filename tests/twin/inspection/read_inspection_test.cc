// What an inspection is to say, and what is refused before the first step, in one sentence.
#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/error.h"
#include "tests/twin/inspection/inspection_for_tests.h"

namespace slackwater::twin::read_inspection_test {
namespace {

using namespace slackwater::twin::tests;

const std::string pile =
    "surfaces: [{kind: monopile, north_m: 0, east_m: 0, radius_m: 3, from: {depth_m: 0}, to: "
    "{depth_m: 20}}]\n";
const std::string looks = "looks: [{instrument: camera, kinds: [monopile], detail_mm: 10}]\n";

std::string refusal_of(const std::string& yaml) {
  try {
    (void)read_inspection(Config::parse(yaml, "test.yaml"));
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
    return error.what();
  }
  return "was not refused";
}

TEST(ReadInspection, WhatIsNotSaidIsThatOfADocumentedDefault) {
  const InspectionPlan plan = read_inspection(Config::parse(pile + looks, "test.yaml"));
  ASSERT_EQ(plan.lines.size(), 1U);
  EXPECT_DOUBLE_EQ(plan.lines[0].detail_m, 0.01);
  EXPECT_DOUBLE_EQ(plan.lines[0].most_incidence_rad, 90 * degree);
  EXPECT_EQ(plan.lines[0].looks, 1U);
  EXPECT_EQ(plan.lines[0].seen_at, 0.9);
  EXPECT_TRUE(plan.defects.entries.empty());
  EXPECT_FALSE(plan.patch_m || plan.rays_per_look);
}

TEST(ReadInspection, WaterGoesByABlackDiscAndAirByItsOpticalRange) {
  const InspectionPlan plan = read_inspection(Config::parse(
      pile + looks + "water: {visibility_m: 8}\nair: {visibility_m: 8000}\n", "test.yaml"));
  EXPECT_NEAR(plan.water.beam_attenuation_per_m, 4.8 / 8, 1e-12);
  EXPECT_NEAR(std::exp(-plan.air.beam_attenuation_per_m * 8000), 0.05, 1e-12);
}

TEST(ReadInspection, WhatCannotBeIsRefusedInOneSentence) {
  struct Bad {
    std::string yaml;
    const char* says;
  };
  const Bad all[] = {
      {looks, "an inspection has at least one surface"},
      {pile, "at least one instrument that looks"},
      {pile + "looks: [{instrument: camera, kinds: [blade], detail_mm: 10}]\n",
       "found blade, but no surface has that name"},
      {pile + "looks: [{instrument: camera, kinds: [monopole], detail_mm: 10}]\n", "monopile"},
      {pile + "looks: [{instrument: camera, detail_mm: 10}]\n", "say which surfaces it inspects"},
      {pile + "looks: [{instrument: camera, kinds: [monopile]}]\n", "detail_mm"},
      {pile +
           "looks: [{instrument: camera, kinds: [monopile], detail_mm: 10}, {instrument: camera, "
           "kinds: [monopile], detail_mm: 5}]\n",
       "inspects each monopile in two entries"},
      {pile + looks + "water: {turbidity_ntu: 4}\n", "turbidity"},
      {pile + looks + "water: {beam_attenuation_per_m: 0.5, visibility_m: 3}\n", "visibility_m"},
      {pile + looks + "defects: [{kind: crack, count: 2}]\n", "name methods of data/detection"},
      {pile + looks + "rays_per_look: 5000\n", "expected a value from 1 to 2000"},
      {"surfaces: [{kind: monopile, north_m: 0, east_m: 0, radius_m: 3, from: {depth_m: 20}, to: "
       "{depth_m: 0}}]\n" +
           looks,
       "from"}};
  for (const Bad& bad : all)
    EXPECT_NE(refusal_of(bad.yaml).find(bad.says), std::string::npos)
        << bad.yaml << "\n-> " << refusal_of(bad.yaml);
}

TEST(ReadyInspection, RefusesWorkThatStaysOutOfReachAndDefectsOffTheSurface) {
  const InspectionFolder folder;
  folder.add("camera",
             "kind: rgb\nrange_m: [0.1, 8]\naim: surface\nframe: {horizontal_deg: 60, pixels_wide: "
             "1920, pixels_high: 1080, exposure_s: 0.01}\n");
  const auto refusal = [&](const std::string& yaml, double north_m) -> std::string {
    try {
      (void)folder.made(yaml, {{{north_m, 0, 10}, 1}});
    } catch (const Error& error) {
      return error.what();
    }
    return "was not refused";
  };
  EXPECT_EQ(refusal(pile + looks, 6), "was not refused");
  EXPECT_NE(refusal(pile + looks, 40).find("and the camera reaches 8 m"), std::string::npos)
      << refusal(pile + looks, 40);
  const std::string off = pile + looks +
                          "defects: [{kind: crack, on: monopile, bearing_deg: 10, depth_m: 30}]\n"
                          "detection: [underwater_visual]\n";
  EXPECT_NE(refusal(off, 6).find("place it on the surface"), std::string::npos) << refusal(off, 6);
  EXPECT_NE(refusal(pile + "looks: [{instrument: camara, kinds: [monopile], detail_mm: 10}]\n", 6)
                .find("camera"),
            std::string::npos);
}

TEST(ReadyInspection, ALongLegThatPassesTheSurfaceBetweenItsEndsComesByIt) {
  const InspectionFolder folder;
  folder.add("camera",
             "kind: rgb\nrange_m: [0.1, 8]\naim: surface\nframe: {horizontal_deg: 60, pixels_wide: "
             "1920, pixels_high: 1080, exposure_s: 0.01}\n");
  const auto inspection = folder.made(pile + looks, {{{6, -100, 10}, 1}, {{6, 100, 10}, 1}});
  EXPECT_NEAR(inspection->pairs[0].range_m, 5, 3);
}

}  // namespace
}  // namespace slackwater::twin::read_inspection_test
