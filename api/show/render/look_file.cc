#include "api/show/render/look_file.h"

#include <limits>

#include "api/program/version.h"
#include "api/show/render/picture_truth.h"
#include "fields/base/text.h"
#include "fields/base/whole_file.h"

namespace slackwater::api {
namespace {

using ingest::netcdf::Type;
using ingest::netcdf::Writer;

void say_look(Writer& writer, const twin::StagedLook& look, const twin::LookStage& sheet) {
  const int of = Writer::global;
  writer.attribute(of, "Conventions", "CF-1.8");
  writer.attribute(of, "title", formatted("look {} at {}", look.number, sheet.name));
  writer.attribute(of, "source", "slackwater " + code_version());
  writer.attribute(of, "sensor", sheet.sensor.name);
  writer.attribute(of, "sensor_source", sheet.sensor.source + " (" + sheet.sensor.status + ")");
  writer.attribute(of, "water_type", look.water);
  writer.attribute(of, "visibility", look.visibility_m);
  say_where(writer, look.pose);
}

std::vector<SeenName> names_of(const std::vector<twin::SeenThing>& things) {
  std::vector<SeenName> names;
  for (const twin::SeenThing& thing : things) names.push_back({thing.name, thing.seen_class});
  return names;
}

std::vector<SeenDefect> defects_of(const twin::StagedLook& look,
                                   const std::vector<SeenName>& things) {
  std::vector<SeenDefect> defects;
  for (const twin::StagedDefect& planted : look.defects) {
    SeenDefect seen;
    seen.number = static_cast<std::uint32_t>(defects.size());
    seen.kind = planted.kind;
    seen.surface = things.at(planted.thing).name;
    seen.thing = planted.thing + 1;
    seen.size_m = planted.size_m;
    seen.severity = std::numeric_limits<double>::quiet_NaN();
    seen.centre_m = planted.centre_m;
    seen.pixels = planted.pixels;
    defects.push_back(seen);
  }
  return defects;
}

}  // namespace

void write_look_netcdf(const twin::StagedLook& look, const twin::Stage& stage,
                       const std::filesystem::path& file) {
  write_beside(file, [&](const std::filesystem::path& partial) {
    Writer writer = Writer::create(partial);
    say_look(writer, look, stage.sheet());
    const std::vector<SeenName> things = names_of(stage.things());
    const std::vector<SeenDefect> defects = defects_of(look, things);
    TruthVariables truth(writer, {look.truth, look.matrix, things, defects});
    writer.end_definitions();
    truth.write();
    writer.close(Writer::Durable::no);
  });
}

}  // namespace slackwater::api
