#include "twin/scenario/read_surroundings.h"

#include <string>
#include <utility>
#include <vector>

#include "fields/base/error.h"
#include "fields/wave/scenario_sea.h"
#include "twin/mission/reach.h"

namespace slackwater::twin {
namespace {

ForecastWater read_forecast(const Config& config) {
  ForecastWater water;
  water.site = config.optional_text("site").value_or("");
  water.file = config.optional_text("file").value_or("");
  if (water.site.empty() == water.file.empty())
    config.refuse("site", "give the site of a forecast in the store, or the file of one");
  water.accept_means = config.optional_flag("accept_means").value_or(false);
  if (const auto day = config.optional_text("day")) {
    try {
      water.day = parse_day(*day);
    } catch (const Error& problem) {
      config.refuse("day", problem.message());
    }
  }
  return water;
}

MadeUpWater read_made_up(const Config& config) {
  MadeUpWater water;
  water.depth_m = config.number("depth_m", {1, 12000});
  double above_m = -1;
  for (const Config& level : config.children("current")) {
    MadeUpLevel at{level.number("depth_m", {0, water.depth_m}), level.number("east_m_s", {-10, 10}),
                   level.number("north_m_s", {-10, 10})};
    if (at.depth_m <= above_m)
      level.refuse("depth_m", "not below the level before it; list levels from the surface down");
    above_m = at.depth_m;
    water.current.push_back(at);
  }
  if (const auto wind = config.optional_child("wind")) {
    water.wind_speed_m_s = wind->number("speed_m_s", {0, 75});
    water.wind_from_deg = wind->number("from_deg", {-360, 360});
  }
  return water;
}

/// @param depth_m  of the water, where that is known
RegularWave read_regular(const Config& waves, std::optional<double> depth_m) {
  for (const char* const other : {"partitions", "components", "height_errors"})
    if (waves.has(other))
      waves.refuse(other, "found beside regular, which is one wave; leave it out");
  const Config config = waves.child("regular");
  RegularWave wave;
  wave.height_m = config.number("height_m", {0.001, 30});
  wave.period_s = config.number("period_s", {0.5, 30});
  wave.from_direction_deg = config.number("from_deg", {-360, 360});
  if (const std::string why = depth_m ? why_it_breaks(wave, *depth_m) : ""; !why.empty())
    config.refuse("height_m", why);
  return wave;
}

}  // namespace

std::variant<ForecastWater, MadeUpWater> read_water(const Config& config) {
  const Config water = config.child("water");
  const auto forecast = water.optional_child("forecast");
  const auto made_up = water.optional_child("made_up");
  if (forecast.has_value() == made_up.has_value())
    config.refuse("water", "give one of forecast and made_up");
  if (forecast) return read_forecast(*forecast);
  return read_made_up(*made_up);
}

ScenarioWaves read_waves(const Config& config, std::optional<double> depth_m) {
  const bool has_forecast = !depth_m;
  ScenarioWaves waves;
  waves.from_forecast = has_forecast;
  const auto c = config.optional_child("waves");
  if (!c) return waves;
  waves.components =
      static_cast<std::size_t>(c->optional_integer("components", 8, 1024).value_or(200));
  const std::string from =
      c->optional_text("from").value_or(c->has("regular")          ? "regular"
                                        : c->is_list("partitions") ? "partitions"
                                                                   : "forecast");
  if (from == "regular" || c->has("regular")) {
    if (from != "regular")
      c->refuse("regular", "found beside from: " + from + "; leave one of the two out");
    waves.from_forecast = false;
    waves.regular = read_regular(*c, depth_m);
    return waves;
  }
  waves.have_height_errors = c->optional_flag("height_errors").value_or(false);
  if (from == "forecast") {
    if (!has_forecast)
      c->refuse(
          "from",
          "made-up water has no wave forecast; give partitions, a regular wave, or from: calm");
    return waves;
  }
  if (waves.have_height_errors)
    c->refuse("height_errors", "found true, but the waves are not from a forecast; leave it out");
  waves.from_forecast = false;
  if (from == "calm") return waves;
  if (from != "partitions")
    c->refuse("from", "found " + from + ", expected forecast, calm, partitions or regular");
  std::vector<WavePartition> partitions;
  for (const Config& p : c->children("partitions")) {
    WavePartition partition;
    partition.significant_height_m = p.number("significant_height_m", {0, 30});
    partition.peak_period_s = p.number("peak_period_s", {0.5, 30});
    partition.from_direction_deg = p.number("from_deg", {-360, 360});
    partition.gamma = p.optional_number("gamma", {1, 10});
    if (const auto s = p.optional_number("spreading_s", {0, 1000})) partition.spreading_s = *s;
    partitions.push_back(partition);
  }
  waves.made_up = scenario_sea(partitions, c->name() + ": waves");
  return waves;
}

ScenarioStructure read_structure(const Config& config) {
  ScenarioStructure s;
  s.name = config.optional_text("name").value_or("structure");
  s.centre_m = {config.number("north_m", within_reach_m), config.number("east_m", within_reach_m),
                0};
  const std::string kind = config.text("kind");
  if (kind == "cylinder") {
    s.diameter_m = config.number("diameter_m", cylinder_diameter_m);
    s.turns_current = config.optional_flag("turns_current").value_or(false);
  } else if (kind == "box") {
    s.kind = ScenarioStructure::Kind::box;
    s.size_m.x = config.number("north_size_m", {0.1, 500});
    s.size_m.y = config.number("east_size_m", {0.1, 500});
  } else {
    config.refuse("kind", "found " + kind + ", expected cylinder or box");
  }
  s.top_m = -config.number("top_height_m", structure_height_m);
  s.bottom_m = config.number("bottom_depth_m", {-500, 12000});
  if (!(s.bottom_m > s.top_m)) config.refuse("bottom_depth_m", "is above the top of the structure");
  s.size_m.z = s.bottom_m - s.top_m;
  return s;
}

}  // namespace slackwater::twin
