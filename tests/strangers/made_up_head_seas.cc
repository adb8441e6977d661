// made_up_head_seas OUT: how the crew transfer vessel answers regular head seas that it lies in
// without way on, and the form of its hulls, for a panel method to answer the same.
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/craft_in_waves.h"

namespace slackwater::tests {
namespace {

using nlohmann::json;

json complex_json(const std::complex<double>& value) { return {value.real(), value.imag()}; }

json head_seas() {
  // data/vehicles/ctv24.yaml: twin prisms of a V.
  constexpr double deadrise_deg = 57.1, length_m = 23.5, half_spacing_m = 3.3, fender_m = 11;
  const twin::Body body = body_of("ctv24");
  const double draught_m = 1.7 + afloat(body).position_m.z;
  json waves = json::array();
  for (const double lengths : {8.0, 6.0, 5.0, 4.0, 3.0, 2.5, 2.0, 1.5}) {
    const RegularWave wave{lengths * length_m, 0.0005 * length_m, 0};
    const Response response = respond(body, wave);
    waves.push_back({{"hull_lengths", lengths},
                     {"omega_rad_s", wave.omega()},
                     {"heave", complex_json(response.heave)},
                     {"pitch", complex_json(response.pitch)}});
  }
  return {{"craft", "ctv24"},
          {"length_m", length_m},
          {"half_spacing_m", half_spacing_m},
          {"deadrise_deg", deadrise_deg},
          {"draught_m", draught_m},
          {"fender_forward_m", fender_m},
          {"mass_kg", body.mass_kg},
          {"pitch_inertia_kg_m2", 3.11e6},
          {"centre_of_gravity_above_m", 1.2},
          {"water_density_kg_m3", constants::sea_water_density_kg_m3},
          {"gravity_m_s2", constants::gravity_m_s2},
          {"waves", waves}};
}

}  // namespace
}  // namespace slackwater::tests

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "made_up_head_seas OUT\n");
    return 2;
  }
  std::ofstream(argv[1]) << slackwater::tests::head_seas().dump(1) << "\n";
  return 0;
}
