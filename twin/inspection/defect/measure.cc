#include "twin/inspection/defect/measure.h"

#include <algorithm>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/sensor/noise.h"

namespace slackwater::twin {

const char* name_of(Quantity quantity) noexcept {
  switch (quantity) {
    case Quantity::scour_depth:
      return "scour_depth";
    case Quantity::burial_depth:
      return "burial_depth";
    case Quantity::wall_thickness:
      return "wall_thickness";
    case Quantity::potential:
      return "potential";
    case Quantity::chain_diameter:
      return "chain_diameter";
    case Quantity::growth_thickness:
      return "growth_thickness";
  }
  return "";
}

const char* unit_of(Quantity quantity) noexcept {
  return quantity == Quantity::potential ? "mV" : "m";
}

std::optional<Quantity> quantity_of(DefectKind defect, InstrumentKind instrument) noexcept {
  const bool is_picture = instrument == InstrumentKind::rgb || instrument == InstrumentKind::lidar;
  if (defect == DefectKind::scour && instrument == InstrumentKind::multibeam)
    return Quantity::scour_depth;
  if (defect == DefectKind::burial_loss && instrument == InstrumentKind::magnetometer)
    return Quantity::burial_depth;
  if (defect == DefectKind::corrosion && instrument == InstrumentKind::thickness)
    return Quantity::wall_thickness;
  if (defect == DefectKind::anode_loss && instrument == InstrumentKind::potential)
    return Quantity::potential;
  if (defect == DefectKind::chain_wear && is_picture) return Quantity::chain_diameter;
  if (defect == DefectKind::marine_growth &&
      (is_picture || instrument == InstrumentKind::multibeam))
    return Quantity::growth_thickness;
  return std::nullopt;
}

double value_of(Quantity quantity, double severity, const DefectFacts& facts) noexcept {
  switch (quantity) {
    case Quantity::scour_depth:
    case Quantity::growth_thickness:
      return severity;
    case Quantity::burial_depth:
      return facts.burial_m - severity;
    case Quantity::wall_thickness:
      return facts.wall_m - severity;
    case Quantity::potential:
      return potential_mv(facts.potential, severity);
    case Quantity::chain_diameter:
      return facts.chain_diameter_m * (1 - severity);
  }
  return 0;
}

double severity_of(Quantity quantity, double value, const DefectFacts& facts) noexcept {
  switch (quantity) {
    case Quantity::scour_depth:
    case Quantity::growth_thickness:
      return std::max(0.0, value);
    case Quantity::burial_depth:
      return std::max(0.0, facts.burial_m - value);
    case Quantity::wall_thickness:
      return std::max(0.0, facts.wall_m - value);
    case Quantity::potential:
      return depletion_of(facts.potential, value);
    case Quantity::chain_diameter:
      return std::max(0.0, 1 - value / facts.chain_diameter_m);
  }
  return 0;
}

double unit_factor(Quantity quantity, const Instrument& instrument) {
  const bool is_potential = quantity == Quantity::potential;
  if (instrument.unit == (is_potential ? "mV" : "m")) return 1;
  if (is_potential && instrument.unit == "V") return 1000;
  if (!is_potential && instrument.unit == "mm") return 1e-3;
  throw Error(
      ErrorKind::invalid_input,
      formatted("{}: its unit is \"{}\", but it is to measure {}; expected {}", instrument.name,
                instrument.unit, name_of(quantity), is_potential ? "mV or V" : "m or mm"));
}

double measured(Quantity quantity, double truth, const Instrument& instrument, double range_m,
                const ReadingKey& key) {
  const double unit = unit_factor(quantity, instrument);
  const double sd = instrument.noise_sd + instrument.noise_per_range * range_m;
  NoiseStream bias(key.seed, formatted("inspection/bias/{}", key.instrument));
  NoiseStream noise(key.seed, formatted("inspection/noise/{}/{}", key.instrument, key.place));
  return truth + unit * (instrument.bias_sd * bias.normal() + sd * noise.normal());
}

}  // namespace slackwater::twin
