// Which turbines of a site are in the scene of a run.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/twin/run/run_for_tests.h"
#include "twin/inspection/surface/make_surface.h"
#include "twin/render/scene/scene_of_run.h"

namespace slackwater::twin::turbines_in_scene_test {
namespace {

class TurbinesInScene : public testing::Test {
 protected:
  TurbinesInScene() {
    const Scenario scenario = parse_scenario(
        slackwater::tests::head(0.05) +
            "  - {name: uav, model: x500, start: {north_m: 0, east_m: 0, height_m: 30}, "
            "tasks: [{do: hold}]}\n",
        "test.yaml");
    Surround surround = slackwater::tests::surround_of(scenario);
    surround.turbine = std::make_shared<Turbine>(
        Turbine::load(surround.data_folder / "turbines" / "nrel_5mw.yaml"));
    surround.turbines_m = {{0, 400}, {0, 4000}};  // east, north
    ready_ = set_up(scenario, surround);
  }

  /// Blades that are seen from this height, of what is inspected there.
  std::size_t blades(double height_m, double reach_m,
                     const std::vector<std::shared_ptr<const Inspection>>& inspections = {}) {
    const EnvironmentSampler sampler(*ready_.environment);
    const RenderScene scene = scene_of_run(
        {sampler, inspections, {}, {}, ready_.vessels, 1, 5, {0, 0, -height_m}, reach_m});
    return static_cast<std::size_t>(
        std::count_if(scene.things.begin(), scene.things.end(),
                      [](const SeenThing& thing) { return thing.seen_class == SeenClass::blade; }));
  }

  ReadyRun ready_;
};

TEST_F(TurbinesInScene, AreThoseWithinReachAboveTheWater) {
  EXPECT_EQ(blades(30, 1000), 3U);
  EXPECT_EQ(blades(30, 5000), 6U);
  EXPECT_EQ(blades(30, 100), 0U);
  EXPECT_EQ(blades(-5, 1000), 0U) << "from under water";
}

TEST_F(TurbinesInScene, AreStoppedWhereTheyAreInspected) {
  const auto inspecting = [](double north_m) {
    PlannedSurface planned;
    planned.name = "tower";
    planned.sizes = TowerSizes{{north_m, 0, -80, -20}, 3, {}, {}};
    auto inspection = std::make_shared<Inspection>();
    inspection->surfaces.push_back(make_surface(planned, 10));
    return std::vector<std::shared_ptr<const Inspection>>{inspection};
  };
  EXPECT_EQ(blades(30, 1000, inspecting(400)), 0U);
  EXPECT_EQ(blades(30, 1000, inspecting(900)), 3U) << "another one is";
}

}  // namespace
}  // namespace slackwater::twin::turbines_in_scene_test
