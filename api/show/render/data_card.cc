#include "api/show/render/data_card.h"

#include <map>

#include "fields/base/constants.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

/// Labels of a kind, and how many of them nobody could tell.
struct Many {
  std::size_t labels = 0;
  std::size_t crowds = 0;
};

std::map<std::string, Many> labels_by_kind(const nlohmann::json& coco) {
  std::map<std::int64_t, std::string> names;
  for (const auto& one : coco.at("categories")) names[one.at("id")] = one.at("name");
  std::map<std::string, Many> out;
  for (const auto& one : coco.at("annotations")) {
    Many& many = out[names.at(one.at("category_id"))];
    ++many.labels;
    many.crowds += one.at("iscrowd").get<int>() == 1 ? 1U : 0U;
  }
  return out;
}

std::string span_words(const Range& range, const char* unit, double scale = 1) {
  return formatted("{:g} to {:g}{}", scale * range.low, scale * range.high, unit);
}

}  // namespace

std::string data_card(const twin::LookStage& stage, std::uint64_t seed,
                      const nlohmann::json& coco) {
  std::vector<std::string> waters, surfaces;
  for (const twin::WaterType& water : stage.waters) waters.push_back(water.name);
  for (const twin::PlannedSurface& one : stage.surfaces) surfaces.push_back(one.name);
  std::string out = formatted(
      "# {}\n\n{} rendered pictures with labels, made by `slackwater stage`, seed {}. No "
      "photograph "
      "is among them.\n\n| drawn for each look | from |\n|---|---|\n",
      stage.name, coco.at("images").size(), seed);
  const auto row = [&](const std::string& what, const std::string& from) {
    out += "| " + what + " | " + from + " |\n";
  };
  row("camera", stage.sensor.name);
  row("surfaces", joined(surfaces, ", "));
  row("range", span_words(stage.range_m, " m"));
  row("off square", span_words(stage.off_square_rad, " degrees", 1 / constants::degree));
  row("visibility", span_words(stage.visibility_m, " m"));
  row("daylight at the surface, of what is needed", span_words(stage.daylight, ""));
  row("lamps, of the sheet's range", span_words(stage.lamps, ""));
  row("growth, 0 none to 1 all", span_words(stage.growth, ""));
  row("water", joined(waters, ", "));
  for (const twin::StagedKind& kind : stage.defects)
    row(formatted("size of {}", name_of(kind.kind)), span_words(kind.size_m, " mm", 1000));
  out += "\n| labels of | in all | that cannot be told (crowd) |\n|---|---|---|\n";
  for (const auto& [kind, many] : labels_by_kind(coco))
    row(kind, formatted("{} | {}", many.labels, many.crowds));
  out +=
      "\n**Stand-ins.** Colours of materials, growth and welds are estimates; defects are "
      "ellipses, "
      "cracks are straight; no marine\nsnow, no scatter that blurs, no motion. A score here says "
      "nothing of a score at sea: hold the detector against your own\npictures, too.\n\n"
      "Licence: that of the program that drew them.\n";
  return out;
}

}  // namespace slackwater::api
