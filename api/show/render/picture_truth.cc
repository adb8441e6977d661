#include "api/show/render/picture_truth.h"

#include "fields/base/text.h"
#include "twin/inspection/defect/defect_kind.h"

namespace slackwater::api {
namespace {

using ingest::netcdf::Type;
using ingest::netcdf::Writer;

void say_classes(Writer& writer, int variable) {
  std::vector<std::string> meanings;
  std::vector<double> values;
  for (std::size_t i = 0; i < twin::seen_classes; ++i) {
    meanings.emplace_back(twin::name_of(static_cast<twin::SeenClass>(i)));
    values.push_back(static_cast<double>(i));
  }
  writer.attribute(variable, "flag_values", values, Type::uint8);
  writer.attribute(variable, "flag_meanings", joined(meanings, " "));
}

void say_kinds(Writer& writer, int variable) {
  std::vector<std::string> meanings;
  std::vector<double> values;
  for (const twin::DefectKind kind : twin::all_defect_kinds()) {
    meanings.emplace_back(twin::name_of(kind));
    values.push_back(static_cast<double>(kind));
  }
  writer.attribute(variable, "flag_values", values, Type::float64);
  writer.attribute(variable, "flag_meanings", joined(meanings, " "));
}

/// One after the other: what the numbers of `defect` stand for. @return ids, and what is to come
std::vector<std::pair<int, std::vector<double>>> add_defects(Writer& writer,
                                                             std::span<const SeenDefect> defects) {
  std::vector<std::pair<int, std::vector<double>>> added;
  if (defects.empty()) return added;
  const std::vector<int> dimensions{writer.dimension("planted", defects.size())};
  const auto add = [&](const char* name, const char* units, const char* words, auto value) {
    std::vector<double> values;
    for (const SeenDefect& one : defects) values.push_back(static_cast<double>(value(one)));
    const int id = writer.variable(name, Type::float64, dimensions);
    writer.attribute(id, "units", units);
    writer.attribute(id, "long_name", words);
    added.emplace_back(id, std::move(values));
    return id;
  };
  add("planted_number", "1", "of the defect in the run",
      [](const SeenDefect& d) { return d.number; });
  say_kinds(writer, add("planted_kind", "1", "of the defect",
                        [](const SeenDefect& d) { return static_cast<int>(d.kind); }));
  add("planted_on", "1", "instance on which it is", [](const SeenDefect& d) { return d.thing; });
  add("planted_size", "m", "longest side", [](const SeenDefect& d) { return d.size_m; });
  add("planted_severity", "1", "m or share, by its kind; NaN: not stated",
      [](const SeenDefect& d) { return d.severity; });
  add("planted_x", "m", "east of the origin", [](const SeenDefect& d) { return d.centre_m.y; });
  add("planted_y", "m", "north of the origin", [](const SeenDefect& d) { return d.centre_m.x; });
  add("planted_z", "m", "up", [](const SeenDefect& d) { return -d.centre_m.z; });
  add("planted_pixels", "1", "of this picture that show it",
      [](const SeenDefect& d) { return d.pixels; });
  return added;
}

std::vector<float> part_of(const std::vector<std::array<float, 3>>& all, std::size_t i) {
  std::vector<float> part;
  part.reserve(all.size());
  for (const auto& one : all) part.push_back(one[i]);
  return part;
}

}  // namespace

TruthVariables::TruthVariables(Writer& writer, const PictureTruth& truth)
    : writer_(writer),
      pixels_(writer, {{"row", static_cast<std::size_t>(truth.frame.high)},
                       {"column", static_cast<std::size_t>(truth.frame.wide)}}) {
  writer.attribute(Writer::global, "camera_matrix", truth.matrix, Type::float64);
  writer.attribute(
      Writer::global, "camera_model",
      "pinhole without distortion; the upper left corner of the picture is (0, 0), the "
      "middle of its first pixel (0.5, 0.5)");
  pixels_.add("range", Type::float32, "m", "from the camera along the ray; NaN: nothing",
              truth.frame.range_m);
  pixels_.add("depth", Type::float32, "m", "along the camera's axis; NaN: nothing",
              truth.frame.depth_m);
  say_names(
      writer, truth.things,
      pixels_.add("instance", Type::uint16, "1", "what is seen, 0: nothing", truth.frame.instance));
  say_classes(writer, pixels_.add("seen_class", Type::uint8, "1", "what kind it is of",
                                  truth.frame.seen_class));
  pixels_.add("defect", Type::uint16, "1",
              "planted defect that is seen: 1 is the first of dimension planted, 0 none",
              truth.frame.defect);
  pixels_.add("normal_right", Type::float32, "1", "of the surface, towards the camera",
              part_of(truth.frame.normal, 0));
  pixels_.add("normal_down", Type::float32, "1", "of the surface, towards the camera",
              part_of(truth.frame.normal, 1));
  pixels_.add("normal_axis", Type::float32, "1", "of the surface, towards the camera",
              part_of(truth.frame.normal, 2));
  defects_ = add_defects(writer, truth.defects);
}

void TruthVariables::write() {
  pixels_.write();
  for (const auto& [id, values] : defects_) writer_.write_all(id, values);
}

}  // namespace slackwater::api
