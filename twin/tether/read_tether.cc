#include "twin/tether/read_tether.h"

#include <string>

#include "fields/base/constants.h"
#include "fields/base/text.h"

namespace slackwater::twin {
namespace {

void expect_a_line(const Config& config, const Tether& tether) {
  const double area_m2 = constants::pi / 4 * tether.diameter_m * tether.diameter_m;
  const double density_kg_m3 = tether.mass_per_m_kg / area_m2;
  // Foam is not lighter than 100 kg/m3, copper not heavier than 9000.
  if (density_kg_m3 < 100 || density_kg_m3 > 9000)
    config.refuse(
        "mass_per_m_kg",
        formatted("found {:g} kg/m, with its diameter a density of {:g} kg/m3; expected 100 to "
                  "9000. Check both units",
                  tether.mass_per_m_kg, density_kg_m3));
  // A bundle of nothing but aramid or HMPE fibres bears 3.6 GPa.
  const double stress_pa = tether.breaking_load_n / area_m2;
  if (stress_pa > 3.6e9)
    config.refuse(
        "breaking_load_n",
        formatted("found {:g} N, which is {:g} GPa in its section; no fibre bears more than 3.6",
                  tether.breaking_load_n, stress_pa / 1e9));
  const double weight_n = tether.mass_per_m_kg * tether.longest_m * constants::gravity_m_s2;
  if (tether.breaking_load_n < weight_n)
    config.refuse("breaking_load_n",
                  formatted("found {:g} N; the line would part under its own weight "
                            "in air, {:g} N. Check the units",
                            tether.breaking_load_n, weight_n));
  if (tether.tangential_drag_coefficient > tether.normal_drag_coefficient)
    config.refuse(
        "tangential_drag_coefficient",
        formatted("found {:g}, more than the {:g} across the line; are the two exchanged?",
                  tether.tangential_drag_coefficient, tether.normal_drag_coefficient));
}

}  // namespace

std::optional<Tether> read_tether(const Config& vehicle) {
  const std::optional<Config> config = vehicle.optional_child("tether");
  if (!config) return std::nullopt;
  Tether tether;
  tether.longest_m = config->number("longest_m", {shortest_tether_m, 10000});
  tether.diameter_m = config->number("diameter_m", {0.0005, 0.2});
  tether.mass_per_m_kg = config->number("mass_per_m_kg", {1e-4, 200});
  tether.breaking_load_n = config->number("breaking_load_n", {10, 1e7});
  // Aramid strength members part at 2.4 to 3.6 % (datasheets of Kevlar 29 and 49 yarn); a braid is
  // no stiffer.
  tether.axial_stiffness_n =
      tether.breaking_load_n /
      config->optional_number("elongation_at_break", {0.001, 0.5}).value_or(0.03);
  tether.normal_drag_coefficient = config->optional_number("normal_drag_coefficient", {0.1, 5})
                                       .value_or(tether.normal_drag_coefficient);
  tether.tangential_drag_coefficient =
      config->optional_number("tangential_drag_coefficient", {0, 1})
          .value_or(tether.tangential_drag_coefficient);
  tether.water_density_kg_m3 = constants::sea_water_density_kg_m3;
  const std::vector<double> at = config->numbers("attachment_m", {-200, 200});
  if (!at.empty() && at.size() != 3)
    config->refuse("attachment_m", "found " + std::to_string(at.size()) +
                                       " numbers; give [x, y, z] in metres, body axes");
  if (!at.empty()) tether.attachment_m = {at[0], at[1], at[2]};
  expect_a_line(*config, tether);
  return tether;
}

}  // namespace slackwater::twin
