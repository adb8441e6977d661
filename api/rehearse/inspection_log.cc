#include "api/rehearse/inspection_log.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "api/rehearse/scenario_run.h"
#include "api/report/plot_json.h"
#include "fields/base/constants.h"

namespace slackwater::api {
namespace {

using ingest::TrajectoryTable;
using nlohmann::json;
using twin::Triple;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double degrees_of_radian = 180 / constants::pi;

/// Rows of a table whose columns are known beforehand.
class Rows {
 public:
  Rows(std::string name, std::vector<TrajectoryTable::Column> columns) {
    table_.name = std::move(name);
    table_.columns = std::move(columns);
  }
  void add(std::initializer_list<double> row) {
    expects(row.size() == table_.columns.size(), "a value for each column");
    auto column = table_.columns.begin();
    for (const double value : row) (column++)->values.push_back(value);
  }
  [[nodiscard]] TrajectoryTable take() { return std::move(table_); }

 private:
  TrajectoryTable table_;
};

Rows patch_rows() {
  return {"inspected_patches",
          {{"pair", "1", "which entry of the attribute inspection, from 0", {}},
           {"along", "m", "of its centre on the sheet, to the right", {}},
           {"down", "m", "of its centre on the sheet, downwards", {}},
           {"width", "m", "on the sheet", {}},
           {"height", "m", "on the sheet", {}},
           {"x", "m", "of its centre, east of the origin", {}},
           {"y", "m", "of its centre, north of the origin", {}},
           {"z", "m", "of its centre, above mean sea level", {}},
           {"normal_x", "1", "outward, east", {}},
           {"normal_y", "1", "outward, north", {}},
           {"normal_z", "1", "outward, up", {}},
           {"area", "m2", "of the patch", {}},
           {"detail", "m", "the least that was made out there", {}},
           {"incidence", "degree", "of that look, off the normal", {}},
           {"range", "m", "of that look", {}},
           {"time", "s", "of that look, since the start", {}},
           {"looks", "1", "that it had in all", {}},
           {"covered", "1", "1: seen as well and as often as asked", {}}}};
}

Rows finding_rows() {
  return {"findings",
          {{"pair", "1", "which entry of the attribute inspection, from 0; -1: of none", {}},
           {"kind",
            "1",
            "crack, corrosion, marine growth, missing fastener, leading edge erosion, "
            "anode loss, scour, burial loss, chain wear, from 0",
            {}},
           {"outcome",
            "1",
            "0 found, 1 false alarm; missed: 2 never seen, 3 seen too poorly, 4 "
            "overlooked",
            {}},
           {"defect", "1", "its number in the made-up truth; -1: there is none", {}},
           {"along", "m", "on the sheet, of its patch", {}},
           {"down", "m", "on the sheet, of its patch", {}},
           {"x", "m", "as reported, east of the origin", {}},
           {"y", "m", "as reported, north of the origin", {}},
           {"z", "m", "as reported, above mean sea level", {}},
           {"true_x", "m", "where it is, east of the origin", {}},
           {"true_y", "m", "where it is, north of the origin", {}},
           {"true_z", "m", "where it is, above mean sea level", {}},
           {"size", "m", "of its longest side, as measured", {}},
           {"true_size", "m", "of its longest side", {}},
           {"severity", "1", "as measured, in the unit of its kind: m, or a share", {}},
           {"true_severity", "1", "in the unit of its kind", {}},
           {"time", "s", "of the look that shows it, since the start", {}},
           {"detail", "m", "that was made out there", {}}}};
}

json pair_json(const Inspected& inspected, std::size_t vehicle, std::size_t pair) {
  const twin::Inspection& what = *inspected.what;
  const twin::InspectedPair& which = what.pairs[pair];
  const twin::InspectionLine& line = what.plan.lines[which.line];
  const twin::Surface& surface = what.surfaces[which.surface];
  const twin::Sheet& sheet = surface.sheet;
  const twin::InspectionOutcome::Part& part = inspected.outcome.parts[pair];
  return {{"vehicle", vehicle},
          {"surface", surface.name},
          {"kind", twin::name_of(surface.kind)},
          {"instrument", part.instrument},
          {"detail_m", number(line.detail_m)},
          {"incidence_deg", number(line.most_incidence_rad * degrees_of_radian)},
          {"looks", line.looks},
          {"done_at", number(line.done_at)},
          {"sheet",
           {{"width_m", number(sheet.width_m)},
            {"height_m", number(sheet.height_m)},
            {"is_all_round", sheet.is_all_round},
            {"along", sheet.along},
            {"down", sheet.down},
            {"first_bearing_deg", number(sheet.first_bearing_rad * degrees_of_radian)},
            {"top_z_m", number(sheet.top_z_m)}}},
          {"area_m2", number(part.area_m2)},
          {"seen_m2", number(part.seen_m2)},
          {"covered_m2", number(part.covered_m2)},
          {"least_detail_m", number(part.least_detail_m)},
          {"median_detail_m", number(part.median_detail_m)}};
}

void add_patches(const Inspected& inspected, std::size_t first_pair, std::size_t pair, Rows& rows) {
  const twin::InspectedPair& which = inspected.what->pairs[pair];
  const twin::Surface& surface = inspected.what->surfaces[which.surface];
  const twin::InspectionLine& line = inspected.what->plan.lines[which.line];
  for (std::size_t p = 0; p < surface.patches.size(); ++p) {
    const twin::Patch& patch = surface.patches[p];
    const twin::BestLook& best = inspected.state.best[pair][p];
    const auto seen = [&](double value) { return best.is_seen() ? value : none; };
    rows.add({static_cast<double>(first_pair + pair), patch.along_m, patch.down_m,
              double{patch.width_m}, double{patch.height_m}, patch.centre_m.y, patch.centre_m.x,
              -patch.centre_m.z, patch.normal.y, patch.normal.x, -patch.normal.z, patch.area_m2,
              seen(best.detail_m),
              seen(std::acos(std::fmin(1.0, double{best.incidence_cosine})) * degrees_of_radian),
              seen(best.range_m), seen(best.t_s), static_cast<double>(best.looks),
              twin::is_covered(line, best) ? 1.0 : 0.0});
  }
}

/// The pair by which something was found; of what was missed, the first that looked there.
std::size_t pair_of(const Inspected& inspected, std::size_t surface,
                    const std::string& instrument) {
  const twin::Inspection& what = *inspected.what;
  for (std::size_t i = 0; i < what.pairs.size(); ++i)
    if (what.pairs[i].surface == surface &&
        (instrument.empty() ||
         what.inspector + "/" + inspected.outcome.parts[i].instrument == instrument))
      return i;
  return what.pairs.size();
}

void add_findings(const Inspected& inspected, std::size_t first_pair, Rows& rows) {
  const auto numbered = [&](std::size_t surface, const std::string& instrument) {
    const std::size_t pair = pair_of(inspected, surface, instrument);
    return pair < inspected.what->pairs.size() ? static_cast<double>(first_pair + pair) : -1.0;
  };
  const auto& surfaces = inspected.what->surfaces;
  for (const twin::Finding& f : inspected.outcome.findings.found) {
    const twin::Patch& patch = surfaces[f.surface].patches[f.patch];
    const bool is_real = f.defect.has_value();
    const auto real = [&](double value) { return is_real ? value : none; };
    rows.add({numbered(f.surface, f.instrument), static_cast<double>(f.kind), is_real ? 0.0 : 1.0,
              is_real ? static_cast<double>(*f.defect) : -1.0, patch.along_m, patch.down_m,
              f.position_m.y, f.position_m.x, -f.position_m.z, real(f.true_position_m.y),
              real(f.true_position_m.x), real(-f.true_position_m.z), f.size_m, real(f.true_size_m),
              f.severity.value_or(none), real(f.true_severity), f.t_s, f.detail_m});
  }
  for (const twin::Miss& m : inspected.outcome.findings.missed) {
    const twin::Patch& patch = surfaces[m.defect.surface].patches[m.defect.patch];
    const double why = m.reason == twin::MissReason::overlooked        ? 4
                       : m.reason == twin::MissReason::seen_too_poorly ? 3
                                                                       : 2;
    const double detail_m = std::isfinite(m.detail_m) ? m.detail_m : none;
    rows.add({numbered(m.defect.surface, ""), static_cast<double>(m.defect.kind), why,
              static_cast<double>(m.defect.number), patch.along_m, patch.down_m, none, none, none,
              patch.centre_m.y, patch.centre_m.x, -patch.centre_m.z, none, m.defect.size_m, none,
              m.defect.severity, none, detail_m});
  }
}

}  // namespace

void add_inspections(std::span<const VehicleSummary> vehicles, ingest::TrajectoryFile& log) {
  json pairs = json::array();
  Rows patches = patch_rows(), findings = finding_rows();
  for (std::size_t v = 0; v < vehicles.size(); ++v) {
    if (!vehicles[v].inspection) continue;
    const Inspected& inspected = *vehicles[v].inspection;
    const std::size_t first_pair = pairs.size();
    for (std::size_t i = 0; i < inspected.what->pairs.size(); ++i) {
      pairs.push_back(pair_json(inspected, v, i));
      add_patches(inspected, first_pair, i, patches);
    }
    add_findings(inspected, first_pair, findings);
  }
  if (pairs.empty()) return;
  log.attributes.emplace_back(inspection_attribute, pairs.dump());
  log.tables.push_back(patches.take());
  log.tables.push_back(findings.take());
}

std::optional<LoggedInspection> inspection_in(const ingest::TrajectoryFile& log,
                                              std::size_t vehicle) {
  const json pairs = json::parse(log.attribute(inspection_attribute), nullptr, false);
  if (!pairs.is_array()) return std::nullopt;
  LoggedInspection out;
  std::vector<bool> is_its_own;
  for (const json& pair : pairs) {
    is_its_own.push_back(pair.value("vehicle", std::size_t{0}) == vehicle);
    if (!is_its_own.back()) continue;
    out.area_m2 += pair.value("area_m2", 0.0);
    out.covered_m2 += pair.value("covered_m2", 0.0);
  }
  if (!(out.area_m2 > 0)) return std::nullopt;
  const TrajectoryTable* table = log.find_table("findings");
  const auto* which = table == nullptr ? nullptr : table->column("pair");
  const auto* outcomes = table == nullptr ? nullptr : table->column("outcome");
  if (which == nullptr || outcomes == nullptr) return out;
  for (std::size_t i = 0; i < table->rows(); ++i) {
    const double pair = (*which)[i], outcome = (*outcomes)[i];
    if (!(pair >= 0 && pair < static_cast<double>(is_its_own.size())) ||
        !is_its_own[static_cast<std::size_t>(pair)])
      continue;
    ++(outcome < 0.5 ? out.found : outcome < 1.5 ? out.false_alarms : out.missed);
  }
  return out;
}

}  // namespace slackwater::api
