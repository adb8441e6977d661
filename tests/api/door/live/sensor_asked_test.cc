// VEHICLE/SENSOR@RATE, as people write it.
#include "api/door/live/topics/sensor_asked.h"

#include <gtest/gtest.h>

#include "fields/base/error.h"
#include "tests/support/contains.h"

namespace slackwater::tests::sensor_asked_test {
namespace {

std::string refusal_of(const std::string& text) {
  try {
    (void)live::sensor_asked(text);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage) << text;
    return error.message();
  }
  return {};
}

TEST(SensorAsked, IsAVehicleASensorAndARate) {
  const live::SensorAsked asked = live::sensor_asked("rov/rov_camera@2");
  EXPECT_EQ(asked.vehicle, "rov");
  EXPECT_EQ(asked.sensor, "rov_camera");
  EXPECT_EQ(asked.rate_hz, 2);
  EXPECT_EQ(live::sensor_asked("a/b@0.25").rate_hz, 0.25);
}

/// Names of vehicles are what people call them; those of sensors are files.
TEST(SensorAsked, AVehicleMayHaveAnyName) {
  const live::SensorAsked asked = live::sensor_asked("rov 1/left@home/rov_camera@10");
  EXPECT_EQ(asked.vehicle, "rov 1/left@home");
  EXPECT_EQ(asked.sensor, "rov_camera");
}

TEST(SensorAsked, WhatIsNoneIsSaidWithAnExample) {
  for (const char* text :
       {"", "rov", "rov/rov_camera", "rov_camera@2", "/rov_camera@2", "rov/@2", "rov/rov_camera@",
        "rov/rov_camera@0", "rov/rov_camera@-1", "rov/rov_camera@2Hz", "rov/rov_camera@nan",
        "rov/rov_camera@inf", "rov/rov_camera@1e999", "@/"}) {
    EXPECT_TRUE(contains(refusal_of(text), "rov/rov_camera@2")) << text;
    EXPECT_TRUE(contains(refusal_of(text), "found '" + std::string(text) + "'")) << text;
  }
}

}  // namespace
}  // namespace slackwater::tests::sensor_asked_test
