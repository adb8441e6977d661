#include "api/door/people/inspected_now.h"

#include <algorithm>

#include "api/door/people/rounded.h"
#include "twin/inspection/inspection_outcome.h"

namespace slackwater::people {
namespace {

using nlohmann::json;

/// Of a list of flags, those that are set, as [[first, how many], ...].
json runs_of(const std::vector<bool>& flags) {
  json runs = json::array();
  for (std::size_t i = 0; i < flags.size();) {
    std::size_t end = i;
    while (end < flags.size() && flags[end]) ++end;
    if (end > i) runs.push_back({i, end - i});
    i = end + 1;
  }
  return runs;
}

}  // namespace

InspectedNow::InspectedNow(std::size_t vehicle, std::shared_ptr<const twin::Inspection> inspection)
    : vehicle_(vehicle), inspection_(std::move(inspection)) {
  for (const twin::Surface& surface : inspection_->surfaces) {
    Part& part = parts_.emplace_back();
    part.is_covered.resize(surface.patches.size());
    part.area_m2 = surface.area_m2();
  }
  for (const twin::InspectedPair& pair : inspection_->pairs) {
    Part& part = parts_[pair.surface];
    part.asked = std::max(part.asked, inspection_->plan.lines[pair.line].seen_at);
  }
}

std::vector<json> InspectedNow::take(const twin::InspectionState& state) {
  std::vector<std::vector<bool>> is_new;
  for (const Part& part : parts_) is_new.emplace_back(part.is_covered.size());
  for (std::size_t i = 0; i < inspection_->pairs.size(); ++i) {
    const twin::InspectedPair& pair = inspection_->pairs[i];
    const twin::InspectionLine& line = inspection_->plan.lines[pair.line];
    const auto& patches = inspection_->surfaces[pair.surface].patches;
    Part& part = parts_[pair.surface];
    for (std::size_t p = 0; p < patches.size(); ++p) {
      if (part.is_covered[p] || !twin::is_covered(line, state.best[i][p])) continue;
      part.is_covered[p] = is_new[pair.surface][p] = true;
      part.covered_m2 += patches[p].area_m2;
    }
  }
  std::vector<json> told;
  for (std::size_t s = 0; s < parts_.size(); ++s)
    if (json runs = runs_of(is_new[s]); !runs.empty()) told.push_back(covered_json(s, runs));
  json findings = json::array();
  for (const twin::Finding& found : twin::inspection_findings(*inspection_, state).findings.found)
    findings.push_back({{"kind", twin::name_of(found.kind)},
                        {"at",
                         {rounded(found.position_m.y, 0.01), rounded(found.position_m.x, 0.01),
                          rounded(-found.position_m.z, 0.01)}},
                        {"size_m", rounded(found.size_m, 1e-4)},
                        {"by", found.instrument}});
  if (findings != findings_) {
    findings_ = std::move(findings);
    told.push_back(findings_json());
  }
  return told;
}

json InspectedNow::covered_json(std::size_t surface, json runs) const {
  return {{"is", "covered"},
          {"vehicle", vehicle_},
          {"surface", surface},
          {"seen", rounded(parts_[surface].seen(), 1e-4)},
          {"runs", std::move(runs)}};
}

std::vector<json> InspectedNow::covered_json() const {
  std::vector<json> all;
  for (std::size_t s = 0; s < parts_.size(); ++s)
    if (json runs = runs_of(parts_[s].is_covered); !runs.empty())
      all.push_back(covered_json(s, runs));
  return all;
}

json InspectedNow::findings_json() const {
  return {{"is", "findings"}, {"vehicle", vehicle_}, {"findings", findings_}};
}

std::vector<json> InspectedNow::surfaces_json() const {
  std::vector<json> all;
  for (std::size_t s = 0; s < parts_.size(); ++s) {
    const twin::Surface& surface = inspection_->surfaces[s];
    all.push_back({{"vehicle", vehicle_},
                   {"surface", s},
                   {"name", surface.name},
                   {"kind", twin::name_of(surface.kind)},
                   {"patches", surface.patches.size()},
                   {"seen", rounded(parts_[s].seen(), 1e-4)},
                   {"asked", parts_[s].asked}});
  }
  return all;
}

json surface_json(const twin::Surface& surface) {
  json corners = json::array(), triangles = json::array(), patch_of = json::array();
  for (std::size_t i = 0; i < surface.mesh.corners.size(); ++i) {
    const twin::Triple<double> at_m = surface.mesh.corner_m(i);
    for (const double value_m : {at_m.y, at_m.x, -at_m.z})
      corners.push_back(rounded(value_m, 1e-3));
  }
  for (const auto& triangle : surface.mesh.triangles)
    for (const std::uint32_t corner : triangle) triangles.push_back(corner);
  for (const std::uint32_t patch : surface.patch_of)
    patch_of.push_back(patch == twin::no_patch ? json(-1) : json(patch));
  return {{"name", surface.name},
          {"kind", twin::name_of(surface.kind)},
          {"corners", corners},
          {"triangles", triangles},
          {"patch_of", patch_of}};
}

}  // namespace slackwater::people
