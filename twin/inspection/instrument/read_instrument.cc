#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fields/base/advice.h"
#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/curve/named_file.h"
#include "twin/inspection/instrument/instrument.h"

namespace slackwater::twin {
namespace {

constexpr std::array kinds{InstrumentKind::rgb,
                           InstrumentKind::infrared,
                           InstrumentKind::lidar,
                           InstrumentKind::multibeam,
                           InstrumentKind::side_scan,
                           InstrumentKind::thickness,
                           InstrumentKind::potential,
                           InstrumentKind::magnetometer,
                           InstrumentKind::acoustic_detection,
                           InstrumentKind::optical_detection,
                           InstrumentKind::radar,
                           InstrumentKind::ais};

InstrumentKind read_kind(const Config& c) {
  const std::string word = c.text("kind");
  std::vector<std::string> known;
  std::string list;
  for (const InstrumentKind kind : kinds) {
    if (word == name_of(kind)) return kind;
    known.emplace_back(name_of(kind));
    list += std::string(list.empty() ? "" : ", ") + name_of(kind);
  }
  c.refuse("kind", "found " + word + did_you_mean(word, known) + ", expected one of " + list);
}

Triple<double> read_triple(const Config& c, std::string_view key, Range range) {
  const auto n = c.numbers(key, range);
  if (n.size() != 3)
    c.refuse(key,
             formatted("found {} numbers, expected three: forward, to the right, down", n.size()));
  return {n[0], n[1], n[2]};
}

FrameFootprint read_frame(const Config& c) {
  FrameFootprint frame;
  frame.horizontal_rad = constants::degree * c.number("horizontal_deg", {0.1, 170});
  frame.pixels_wide = c.integer("pixels_wide", 2, 100000);
  frame.pixels_high = c.integer("pixels_high", 2, 100000);
  frame.exposure_s = c.number("exposure_s", {0, 60});
  if (const auto vertical_deg = c.optional_number("vertical_deg", {0.1, 170}))
    frame.vertical_rad = constants::degree * *vertical_deg;
  else
    frame.vertical_rad =
        2 * std::atan(std::tan(frame.horizontal_rad / 2) * frame.pixels_high / frame.pixels_wide);
  return frame;
}

FanFootprint read_fan(const Config& c) {
  FanFootprint fan;
  fan.across_rad = constants::degree * c.number("across_deg", {0.1, 360});
  fan.blind_rad = constants::degree * c.optional_number("blind_deg", {0, 360}).value_or(0);
  if (fan.blind_rad >= fan.across_rad)
    c.refuse("blind_deg",
             "nothing is left of the fan: the blind angle about its axis is to be "
             "less than across_deg");
  fan.beam_across_rad = constants::degree * c.number("beam_across_deg", {1e-4, 90});
  fan.beam_along_rad = constants::degree * c.number("beam_along_deg", {1e-4, 90});
  fan.pings_per_s = c.number("pings_per_s", {0.01, 1e6});
  return fan;
}

InstrumentFootprint read_footprint(const Config& c) {
  constexpr std::array<std::string_view, 4> shapes{"frame", "fan", "spot", "round"};
  const auto given = std::count_if(shapes.begin(), shapes.end(),
                                   [&](std::string_view shape) { return c.has(shape); });
  if (given != 1)
    c.refuse("kind", formatted("found {} footprints; give the instrument one of frame, fan, spot "
                               "and round: where it measures at one moment",
                               given));
  if (const auto frame = c.optional_child("frame")) return read_frame(*frame);
  if (const auto fan = c.optional_child("fan")) return read_fan(*fan);
  if (const auto spot = c.optional_child("spot")) {
    const double spot_m = spot->number("spot_m", {1e-4, 10});
    return SpotFootprint{spot_m, spot->number("dwell_s", {0, 600}),
                         spot->optional_number("speaks_for_m", {0, 100}).value_or(0.5 * spot_m)};
  }
  return RoundFootprint{c.child("round").number("detail_m", {1e-3, 1e4})};
}

void read_aim(const Config& c, Instrument& instrument) {
  if (!c.has("aim")) return;
  if (!c.is_mapping("aim")) {
    const std::string aim = c.text("aim");
    if (aim != "surface")
      c.refuse("aim", "found " + aim +
                          ", expected surface, for what is turned to it, or "
                          "{axis: [1, 0, 0]}, for what is fixed to the hull");
    instrument.aim = Aim::surface;
    return;
  }
  const Config aim = c.child("aim");
  const Triple<double> axis = read_triple(aim, "axis", {-1, 1});
  const double length = length_of(axis);
  if (!(length > 0)) aim.refuse("axis", "points nowhere; [1, 0, 0] is ahead, [0, 0, 1] down");
  instrument.axis = (1 / length) * axis;
  if (std::holds_alternative<FanFootprint>(instrument.footprint) &&
      std::abs(instrument.axis.x) > 0.99)
    aim.refuse("axis", "a fan stands across the hull; let it look down, up or aside");
}

void read_noise(const Config& c, Instrument& instrument) {
  const auto noise = c.optional_child("noise");
  if (!noise) return;
  if (!noise->has("unit"))
    c.refuse("noise", "has no unit; add that of what is measured, e.g. unit: m, mm or mV");
  instrument.unit = noise->text("unit");
  instrument.noise_sd = noise->optional_number("sd", {0, 1e6}).value_or(0);
  instrument.noise_per_range = noise->optional_number("per_range", {0, 1e6}).value_or(0);
  instrument.bias_sd = noise->optional_number("bias_sd", {0, 1e6}).value_or(0);
}

}  // namespace

Instrument read_instrument(const Config& c) {
  Instrument instrument;
  instrument.name = c.text("name");
  instrument.source = c.text("source");
  instrument.status = c.text("status");
  instrument.kind = read_kind(c);
  instrument.footprint = read_footprint(c);
  const auto range = c.numbers("range_m", {0, 1e5});
  if (range.size() != 2)
    c.refuse("range_m", formatted("found {} numbers, expected two: the least and the most at "
                                  "which it measures",
                                  range.size()));
  if (!(range[0] < range[1]))
    c.refuse("range_m", formatted("found [{:g}, {:g}], the wrong way round: the least range stands "
                                  "first, and is less than the most",
                                  range[0], range[1]));
  instrument.least_range_m = range[0];
  instrument.most_range_m = range[1];
  read_aim(c, instrument);
  if (c.has("position_m")) instrument.position_m = read_triple(c, "position_m", {-100, 100});
  instrument.needs_light = c.optional_flag("needs_light").value_or(false);
  instrument.lamp_range_m = c.optional_number("lamp_range_m", {0, 1e4}).value_or(0);
  if (instrument.lamp_range_m > 0)
    instrument.lamp_aside_m =
        c.optional_number("lamp_aside_m", {0.01, 100}).value_or(instrument.lamp_aside_m);
  read_noise(c, instrument);
  c.expect_all_read();
  return instrument;
}

Instrument read_named_instrument(const std::string& name,
                                 const std::filesystem::path& data_folder) {
  return read_instrument(open_named(name, "inspection: instrument", data_folder / "instruments"));
}

}  // namespace slackwater::twin
