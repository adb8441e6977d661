#pragma once
#include <string>
#include <vector>

#include "fields/base/text.h"
#include "tests/support/shared_data.h"
#include "twin/inspection/defect/find_defects.h"

namespace slackwater::tests {

/// A level sheet of patches, row by row from its north-west corner: east is along, south is down,
/// at a depth of 10 m.
/// @param widths_m  of the columns  @param heights_m  of the rows
inline twin::Surface sheet_of(const std::string& name, twin::SurfaceKind kind,
                              const std::vector<float>& widths_m,
                              const std::vector<float>& heights_m) {
  twin::Surface surface;
  surface.name = name;
  surface.kind = kind;
  double down_m = 0;
  for (const float height_m : heights_m) {
    double along_m = 0;
    for (const float width_m : widths_m) {
      twin::Patch patch;
      patch.along_m = along_m + 0.5 * static_cast<double>(width_m);
      patch.down_m = down_m + 0.5 * static_cast<double>(height_m);
      patch.centre_m = {-patch.down_m, patch.along_m, 10};
      patch.normal = {0, 0, -1};
      patch.area_m2 = static_cast<double>(width_m) * static_cast<double>(height_m);
      patch.width_m = width_m;
      patch.height_m = height_m;
      surface.patches.push_back(patch);
      along_m += static_cast<double>(width_m);
    }
    down_m += static_cast<double>(height_m);
    surface.sheet.width_m = along_m;
  }
  surface.sheet.height_m = down_m;
  return surface;
}
inline twin::Surface squares(const std::string& name, twin::SurfaceKind kind, std::size_t columns,
                             std::size_t rows, float side_m = 1) {
  return sheet_of(name, kind, std::vector<float>(columns, side_m),
                  std::vector<float>(rows, side_m));
}

inline const twin::DefectFacts& facts() {
  static const twin::DefectFacts read = twin::read_defect_facts(
      Config::load(source_folder() / "data" / "defects" / "offshore_wind.yaml"));
  return read;
}

inline twin::Instrument instrument(twin::InstrumentKind kind, const std::string& unit = "m") {
  twin::Instrument made;
  made.name = "made up";
  made.kind = kind;
  made.unit = unit;
  return made;
}

inline std::vector<twin::BestLook> seen(std::size_t patches, double detail_m) {
  twin::BestLook look;
  look.detail_m = static_cast<float>(detail_m);
  look.looks = 1;
  return std::vector<twin::BestLook>(patches, look);
}

/// A method of made-up figures, with other keys in the place of those given.
inline std::string method_yaml(const std::string& curve, const std::string& more = {},
                               const std::string& kinds = "finds: [crack]\nby: [rgb]\n") {
  return "name: Made up\nsource: this test\nstatus: estimate\n" + kinds + curve + "\n" +
         "at_detail_mm: 2\nfalse_alarms_per_100_m2: 0\n" + more;
}
inline twin::DetectionMethod method(const std::string& yaml) {
  return twin::read_detection_method(Config::parse(yaml, "made_up.yaml"));
}

/// What an action throws; empty where it does not.
template <typename Action>
std::string message_of(Action&& action) {
  try {
    action();
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

}  // namespace slackwater::tests
