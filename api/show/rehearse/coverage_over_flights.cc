#include "api/show/rehearse/coverage_over_flights.h"

#include <nlohmann/json.hpp>

#include "api/json/plot_json.h"
#include "api/show/coverage/pictures.h"
#include "api/show/rehearse/over_flights.h"
#include "fields/base/angle.h"
#include "fields/base/text.h"
#include "twin/agent/conduct.h"

namespace slackwater::api {
namespace {

using nlohmann::json;
using twin::InspectionOutcome;

constexpr StateWords words_of_flights{"covered in at least 9 of 10 futures", "in some",
                                      "in fewer than 1 of 10"};

Vector3<Enu> enu(const twin::Triple<double>& ned) { return {ned.y, ned.x, -ned.z}; }

PatchState state_of(double share) {
  return share >= sure_share - 1e-9      ? PatchState::covered
         : share > 1 - sure_share + 1e-9 ? PatchState::seen_poorly
                                         : PatchState::unseen;
}

CoverageSheet laid_flat(const twin::Sheet& sheet) {
  return {sheet.width_m, sheet.height_m, sheet.is_all_round,
          sheet.along,   sheet.down,     Angle::from_radians(sheet.first_bearing_rad).degrees(),
          sheet.top_z_m};
}

/// A pair without a word of how well it was seen.
InspectionCoverage asked_of(const twin::Inspection& what, std::size_t pair) {
  const twin::InspectionLine& line = what.plan.lines[what.pairs[pair].line];
  const twin::Surface& surface = what.surfaces[what.pairs[pair].surface];
  InspectionCoverage coverage;
  coverage.vehicle = what.inspector;
  coverage.surface = surface.name;
  coverage.kind = twin::name_of(surface.kind);
  coverage.instrument = what.instruments[what.pairs[pair].line].name;
  coverage.asked_detail_m = line.detail_m;
  coverage.asked_incidence_deg = Angle::from_radians(line.most_incidence_rad).degrees();
  coverage.asked_looks = line.looks;
  coverage.done_at = line.seen_at;
  coverage.words = words_of_flights;
  coverage.sheet = laid_flat(surface.sheet);
  return coverage;
}

InspectionCoverage over_flights(const OverFlights<InspectionOutcome>& all,
                                const twin::Inspection& what, std::size_t pair) {
  InspectionCoverage coverage = asked_of(what, pair);
  const auto& patches = what.surfaces[what.pairs[pair].surface].patches;
  const double flights = static_cast<double>(std::distance(all.begin(), all.end()));
  for (std::size_t p = 0; p < patches.size(); ++p) {
    double times = 0;
    for (const InspectionOutcome* flown : all) times += flown->parts[pair].covered[p] ? 1 : 0;
    CoveragePatch patch;
    patch.along_m = patches[p].along_m;
    patch.down_m = patches[p].down_m;
    patch.width_m = double{patches[p].width_m};
    patch.height_m = double{patches[p].height_m};
    patch.centre_m = enu(patches[p].centre_m);
    patch.normal = enu(patches[p].normal);
    patch.area_m2 = patches[p].area_m2;
    patch.state = state_of(times / flights);
    coverage.area_m2 += patch.area_m2;
    if (patch.state != PatchState::unseen) coverage.seen_m2 += patch.area_m2;
    if (patch.state == PatchState::covered) coverage.covered_m2 += patch.area_m2;
    coverage.patches.push_back(patch);
  }
  return coverage;
}

std::string sentence(const OverFlights<InspectionOutcome>& all, const InspectionCoverage& coverage,
                     std::size_t pair) {
  const auto share = [&](double at) {
    return percent_text(all.quantile(at, [&](const auto& o) { return o.parts[pair].share(); }));
  };
  return coverage.instrument + " of " + coverage.vehicle +
         formatted(
             ": {} of {:.1f} m2 covered in the middle future, {} in the P10 and {} in the P90 one",
             share(0.5), coverage.area_m2, share(0.1), share(0.9)) +
         asked_share_text(coverage) + ".";
}

bool is_at_work(const twin::FlightSample& sample) {
  return sample.phase == static_cast<std::uint8_t>(twin::Phase::work) &&
         sample.doing == static_cast<std::uint8_t>(twin::Doing::task);
}

/// Whether it is above the sea at more than half of its samples at work, over all flights.
bool works_in_the_air(const StartOutcome& start, std::size_t vehicle) {
  constexpr float above_deck_m = 3;
  std::ptrdiff_t in_air = 0;
  for (const twin::Flight& flight : start.flights)
    for (const twin::FlightSample& sample : flight.samples[vehicle])
      if (is_at_work(sample)) in_air += sample.down_m < -above_deck_m ? 1 : -1;
  return in_air > 0;
}

/// Mean over the samples at work; nothing: it never was.
std::optional<double> flow_at_work_m_s(const std::vector<twin::FlightSample>& samples,
                                       float twin::FlightSample::*flow) {
  double sum = 0;
  std::size_t count = 0;
  for (const twin::FlightSample& sample : samples) {
    if (!is_at_work(sample)) continue;
    sum += double{sample.*flow};
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / static_cast<double>(count);
}

}  // namespace

std::vector<InspectionCoverage> coverage_over_flights(const StartOutcome& start,
                                                      std::size_t vehicle,
                                                      const twin::Inspection* what) {
  std::vector<InspectionCoverage> coverages;
  if (what == nullptr || start.flights.empty()) return coverages;
  const OverFlights all(start, vehicle, &twin::VehicleAccount::inspection);
  if (all.empty()) return coverages;
  for (std::size_t pair = 0; pair < what->pairs.size(); ++pair)
    coverages.push_back(over_flights(all, *what, pair));
  return coverages;
}

std::string rehearsed_coverage_html(const StartOutcome& start,
                                    const twin::InspectionShelf& inspections) {
  if (start.flights.empty()) return {};
  std::string pictures;
  const auto& vehicles = start.flights.front().vehicles;
  for (std::size_t v = 0; v < vehicles.size(); ++v) {
    const auto found = inspections.find(vehicles[v].name);
    if (found == inspections.end()) continue;
    const OverFlights all(start, v, &twin::VehicleAccount::inspection);
    const auto coverages = coverage_over_flights(start, v, found->second.get());
    for (std::size_t pair = 0; pair < coverages.size(); ++pair)
      pictures += pictures_html(coverages[pair], {}, sentence(all, coverages[pair], pair));
  }
  if (pictures.empty()) return {};
  return coverage_section_html(
      "What is covered, over all futures", pictures,
      formatted("Of a start at {}Z, over its {} futures. What is covered only in some of them "
                "depends on current, wind and waves.",
                format_utc(start.start).substr(0, 16), start.flights.size()));
}

json covered_against_flow_json(const StartOutcome& start, std::size_t vehicle) {
  const bool in_air = works_in_the_air(start, vehicle);
  const auto flow = in_air ? &twin::FlightSample::wind_m_s : &twin::FlightSample::current_m_s;
  json points = json::array();
  for (const twin::Flight& flight : start.flights) {
    const auto& inspection = flight.vehicles[vehicle].inspection;
    if (!inspection) continue;
    const auto flow_m_s = flow_at_work_m_s(flight.samples[vehicle], flow);
    points.push_back({flow_m_s ? number(*flow_m_s) : json(nullptr),
                      number(100 * inspection->share()), flight.flown.member});
  }
  if (points.empty()) return nullptr;
  return {{"in", in_air ? "wind" : "current"}, {"points", points}};
}

}  // namespace slackwater::api
