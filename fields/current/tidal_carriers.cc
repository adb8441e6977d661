#include "fields/current/tidal_carriers.h"

#include <cmath>
#include <string_view>

#include "fields/base/constants.h"

namespace slackwater {

std::vector<TidalCarrier> tidal_carriers_for(Duration record) {
  const double record_s = std::chrono::duration<double>(record).count();
  const auto constituent = [](std::string_view name) { return &tidal_constituent(name); };
  const auto can_split = [record_s](std::string_view a, std::string_view b) {
    const double apart =
        std::abs(tidal_constituent(a).speed_rad_s - tidal_constituent(b).speed_rad_s);
    // The table of periods is rounded; a record of exactly the Rayleigh length splits the pair.
    return record_s * apart >= 2.0 * constants::pi * (1.0 - 1.0e-6);
  };
  // Ratios of the equilibrium tide: Doodson (1921) coefficients 0.90809 (M2), 0.42248 (S2), 0.53011
  // (K1), 0.37694 (O1); the others likewise from their coefficients.
  TidalCarrier m2{constituent("M2"), {}};
  TidalCarrier s2{constituent("S2"), {}};
  TidalCarrier k1{constituent("K1"), {}};
  TidalCarrier o1{constituent("O1"), {}};
  std::vector<TidalCarrier> chosen;
  const bool splits_n2 = can_split("M2", "N2");
  const bool splits_half_a_year = can_split("S2", "K2");
  const bool splits_s2 = can_split("M2", "S2");
  const bool splits_o1 = can_split("K1", "O1");
  if (!splits_s2) m2.carried.push_back({constituent("S2"), 0.465});
  if (!splits_n2) m2.carried.push_back({constituent("N2"), 0.191});
  if (!splits_half_a_year) s2.carried.push_back({constituent("K2"), 0.272});
  if (!splits_o1) k1.carried.push_back({constituent("O1"), 0.711});
  if (!splits_half_a_year) k1.carried.push_back({constituent("P1"), 0.331});
  if (!splits_n2) o1.carried.push_back({constituent("Q1"), 0.191});
  chosen.push_back(m2);
  if (splits_s2) chosen.push_back(s2);
  chosen.push_back(k1);
  if (splits_o1) chosen.push_back(o1);
  const auto alone = [&](std::string_view name) { chosen.push_back({constituent(name), {}}); };
  alone("M4");
  if (splits_s2) alone("MS4");
  if (splits_n2)
    for (const std::string_view name : {"N2", "Q1", "MN4", "M6"}) alone(name);
  if (splits_half_a_year)
    for (const std::string_view name : {"K2", "P1", "MSf"}) alone(name);
  return chosen;
}

Horizontal inference_factor(const Constituent& carrier, const InferredConstituent& inferred,
                            UtcTime reference) {
  return std::polar(inferred.ratio, astronomical_argument_rad(*inferred.constituent, reference) -
                                        astronomical_argument_rad(carrier, reference));
}

}  // namespace slackwater
