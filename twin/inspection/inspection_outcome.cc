#include "twin/inspection/inspection_outcome.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/base/text.h"

namespace slackwater::twin {
namespace {

InspectionOutcome::Part part_of(const Inspection& inspection, const InspectedPair& pair,
                                std::span<const BestLook> best) {
  const Surface& surface = inspection.surfaces[pair.surface];
  const InspectionLine& line = inspection.plan.lines[pair.line];
  InspectionOutcome::Part part;
  part.surface = surface.name;
  part.instrument = inspection.instruments[pair.line].name;
  part.kind = surface.kind;
  part.asked = line.seen_at;
  part.least_detail_m = part.median_detail_m = std::numeric_limits<double>::infinity();
  part.covered.resize(surface.patches.size());
  std::vector<std::pair<float, double>> details;  // with the area that was seen so
  for (std::size_t p = 0; p < surface.patches.size(); ++p) {
    const double area_m2 = surface.patches[p].area_m2;
    part.area_m2 += area_m2;
    if (!best[p].is_seen()) continue;
    part.seen_m2 += area_m2;
    part.covered[p] = is_covered(line, best[p]);
    if (part.covered[p]) part.covered_m2 += area_m2;
    details.emplace_back(best[p].detail_m, area_m2);
  }
  std::sort(details.begin(), details.end());
  if (!details.empty()) part.least_detail_m = details.front().first;
  double so_far_m2 = 0;
  for (const auto& [detail_m, area_m2] : details) {
    so_far_m2 += area_m2;
    if (so_far_m2 < 0.5 * part.area_m2) continue;
    part.median_detail_m = detail_m;
    break;
  }
  return part;
}

/// What a line of the plan lacks; empty: nothing.
std::string left_of(const Inspection& inspection, std::size_t line,
                    std::span<const InspectionOutcome::Part> parts) {
  double area_m2 = 0, covered_m2 = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (inspection.pairs[i].line != line) continue;
    area_m2 += parts[i].area_m2;
    covered_m2 += parts[i].covered_m2;
  }
  const InspectionLine& plan = inspection.plan.lines[line];
  if (covered_m2 >= plan.seen_at * area_m2) return "";
  return formatted("less than {:g} % covered by the {}", 100 * plan.seen_at,
                   inspection.instruments[line].name);
}

std::vector<SurfaceLooks> looks_of(const Inspection& inspection, const InspectionState& state) {
  std::vector<SurfaceLooks> looks;
  for (std::size_t i = 0; i < inspection.pairs.size(); ++i) {
    const InspectedPair& pair = inspection.pairs[i];
    looks.push_back({pair.surface,
                     inspection.inspector + "/" + inspection.instruments[pair.line].name,
                     &inspection.instruments[pair.line], state.best[i],
                     inspection.plan.lines[pair.line].detail_m});
  }
  return looks;
}

}  // namespace

bool is_covered(const InspectionLine& line, const BestLook& best) noexcept {
  return best.looks >= line.looks && best.detail_m <= line.detail_m &&
         best.incidence_cosine >= std::cos(line.most_incidence_rad) - 1e-6;
}

std::optional<bool> InspectionOutcome::is_seen() const noexcept {
  const auto asks = [](const Part& part) { return part.asked > 0; };
  if (std::none_of(parts.begin(), parts.end(), asks)) return std::nullopt;
  return left.empty();
}

double InspectionOutcome::area_m2() const noexcept {
  double sum_m2 = 0;
  for (const Part& part : parts) sum_m2 += part.area_m2;
  return sum_m2;
}

double InspectionOutcome::covered_m2() const noexcept {
  double sum_m2 = 0;
  for (const Part& part : parts) sum_m2 += part.covered_m2;
  return sum_m2;
}

double InspectionOutcome::share() const noexcept {
  return area_m2() > 0 ? covered_m2() / area_m2() : 0;
}

InspectionFindings inspection_findings(const Inspection& inspection, const InspectionState& state) {
  InspectionFindings out;
  out.planted = plant(inspection.plan.defects, inspection.surfaces, inspection.facts, state.seed);
  out.findings = find_defects(out.planted, inspection.surfaces, looks_of(inspection, state),
                              inspection.methods, inspection.facts, state.seed);
  return out;
}

InspectionOutcome inspection_outcome(const Inspection& inspection, const InspectionState& state) {
  InspectionOutcome out;
  for (std::size_t i = 0; i < inspection.pairs.size(); ++i)
    out.parts.push_back(part_of(inspection, inspection.pairs[i], state.best[i]));
  for (const InspectionState::Line& line : state.lines) out.looks += line.looks;
  out.rays = state.rays;
  out.worked_s = state.worked_s;
  for (std::size_t l = 0; l < inspection.plan.lines.size() && out.left.empty(); ++l)
    out.left = left_of(inspection, l, out.parts);
  const InspectionFindings all = inspection_findings(inspection, state);
  out.score = score_of(all.planted, all.findings);
  return out;
}

}  // namespace slackwater::twin
