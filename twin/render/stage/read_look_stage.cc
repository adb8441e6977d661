#include <algorithm>
#include <cmath>

#include "fields/base/advice.h"
#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/render/stage/look_stage.h"

namespace slackwater::twin {
namespace {

Range read_span(const Config& c, std::string_view key, Range allowed) {
  const std::vector<double> two = c.numbers(key, allowed);
  if (two.size() != 2 || !(two[0] <= two[1]))
    c.refuse(key, formatted("found {}, expected two numbers, the lower one first",
                            two.size() == 2 ? formatted("{:g} and {:g}", two[0], two[1])
                                            : counted(two.size(), "number")));
  return {two[0], two[1]};
}

StagedKind read_staged_kind(const Config& entry, const std::vector<PlannedSurface>& surfaces) {
  StagedKind staged;
  const std::string word = entry.text("kind");
  const auto kind = defect_kind_named(word);
  std::vector<std::string> known;
  for (const DefectKind one : all_defect_kinds()) known.emplace_back(name_of(one));
  if (!kind)
    entry.refuse("kind", "found " + word + did_you_mean(word, known) + ", expected one of " +
                             joined(known, ", "));
  staged.kind = *kind;
  if (std::none_of(surfaces.begin(), surfaces.end(), [&](const PlannedSurface& surface) {
        return may_sit_on(*kind, surface.kind());
      }))
    entry.refuse("kind", "found " + word +
                             ", which sits on none of the stage's surfaces; add a "
                             "surface that it sits on, or take it out");
  staged.size_m = read_span(entry, "size_m", {0.001, 100});
  return staged;
}

RenderSensor read_camera(const Config& config, const std::filesystem::path& data_folder) {
  RenderSensor sensor = read_named_render_sensor(config.text("sensor"), data_folder);
  if (!sensor.is_camera())
    config.refuse("sensor", "found " + sensor.name +
                                ", which is no camera; a stage is looked at by a camera");
  return sensor;
}

}  // namespace

LookStage read_look_stage(const Config& config, const std::filesystem::path& data_folder) {
  using constants::degree;
  LookStage stage;
  stage.name = config.text("name");
  stage.source = config.text("source");
  stage.sensor = read_camera(config, data_folder);
  for (const Config& entry : config.children("surfaces"))
    stage.surfaces.push_back(read_surface(entry));
  if (stage.surfaces.empty()) config.refuse("surfaces", "found none, expected at least one");
  if (const auto defects = config.children("defects"); !defects.empty())
    for (const Config& entry : defects)
      stage.defects.push_back(read_staged_kind(entry, stage.surfaces));
  stage.most_defects = config.integer("most_defects", stage.defects.empty() ? 0 : 1, 20);
  stage.share_without = config.number("share_without", {0, 1});
  stage.range_m = read_span(config, "range_m", {0.05, 5000});
  if (stage.range_m.low < stage.sensor.least_range_m ||
      stage.range_m.high > stage.sensor.most_range_m)
    config.refuse("range_m", formatted("found {:g} to {:g} m, but {} sees from {:g} to {:g} m",
                                       stage.range_m.low, stage.range_m.high, stage.sensor.name,
                                       stage.sensor.least_range_m, stage.sensor.most_range_m));
  // Beyond 80 degrees a surface is seen so flatly that nothing on it shows.
  const Range off = read_span(config, "off_square_deg", {0, 80});
  stage.off_square_rad = {degree * off.low, degree * off.high};
  stage.most_roll_rad = degree * config.number("roll_deg", {0, 180});
  stage.visibility_m = read_span(config, "visibility_m", {0.1, 2e5});
  stage.daylight = read_span(config, "daylight", {1e-6, 100});
  stage.lamps = read_span(config, "lamps", {0.01, 10});
  stage.growth = read_span(config, "growth", {0, 1});
  for (const std::string& water : config.texts("waters"))
    stage.waters.push_back(read_named_water_type(water, data_folder));
  if (stage.waters.empty()) config.refuse("waters", "found none, expected at least one");
  config.expect_all_read();
  return stage;
}

}  // namespace slackwater::twin
