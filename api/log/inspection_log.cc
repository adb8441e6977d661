#include "api/log/inspection_log.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "api/json/plot_json.h"
#include "api/log/table_reader.h"
#include "api/log/table_rows.h"
#include "fields/base/constants.h"
#include "fields/base/error.h"

namespace slackwater::api {
namespace {

using ingest::TrajectoryTable;
using nlohmann::json;
using twin::InspectionOutcome;

constexpr double degrees_of_radian = 180 / constants::pi;

TableRows patch_rows() {
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

TableRows finding_rows() {
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
          {"done_at", number(line.seen_at)},
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

void add_patches(const Inspected& inspected, std::size_t first_pair, std::size_t pair,
                 TableRows& rows) {
  const twin::InspectedPair& which = inspected.what->pairs[pair];
  const twin::Surface& surface = inspected.what->surfaces[which.surface];
  const twin::InspectionLine& line = inspected.what->plan.lines[which.line];
  for (std::size_t p = 0; p < surface.patches.size(); ++p) {
    const twin::Patch& patch = surface.patches[p];
    const twin::BestLook& best = inspected.state.best[pair][p];
    const auto seen = [&](double value) { return best.is_seen() ? value : constants::nan; };
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

void add_findings(const Inspected& inspected, std::size_t first_pair, TableRows& rows) {
  const auto numbered = [&](std::size_t surface, const std::string& instrument) {
    const std::size_t pair = pair_of(inspected, surface, instrument);
    return pair < inspected.what->pairs.size() ? static_cast<double>(first_pair + pair) : -1.0;
  };
  const auto& surfaces = inspected.what->surfaces;
  for (const twin::Finding& f : inspected.findings.found) {
    const twin::Patch& patch = surfaces[f.surface].patches[f.patch];
    const bool is_real = f.defect.has_value();
    const auto real = [&](double value) { return is_real ? value : constants::nan; };
    rows.add({numbered(f.surface, f.instrument), static_cast<double>(f.kind), is_real ? 0.0 : 1.0,
              is_real ? static_cast<double>(*f.defect) : -1.0, patch.along_m, patch.down_m,
              f.position_m.y, f.position_m.x, -f.position_m.z, real(f.true_position_m.y),
              real(f.true_position_m.x), real(-f.true_position_m.z), f.size_m, real(f.true_size_m),
              f.severity.value_or(constants::nan), real(f.true_severity), f.t_s, f.detail_m});
  }
  for (const twin::Miss& m : inspected.findings.missed) {
    const twin::Patch& patch = surfaces[m.defect.surface].patches[m.defect.patch];
    const double why = m.reason == twin::MissReason::overlooked        ? 4
                       : m.reason == twin::MissReason::seen_too_poorly ? 3
                                                                       : 2;
    const double detail_m = std::isfinite(m.detail_m) ? m.detail_m : constants::nan;
    rows.add({numbered(m.defect.surface, ""), static_cast<double>(m.defect.kind), why,
              static_cast<double>(m.defect.number), patch.along_m, patch.down_m, constants::nan,
              constants::nan, constants::nan, patch.centre_m.y, patch.centre_m.x, -patch.centre_m.z,
              constants::nan, m.defect.size_m, constants::nan, m.defect.severity, constants::nan,
              detail_m});
  }
}

}  // namespace

void add_inspections(std::span<const std::optional<Inspected>> vehicles,
                     ingest::TrajectoryFile& log) {
  json pairs = json::array();
  TableRows patches = patch_rows(), findings = finding_rows();
  for (std::size_t v = 0; v < vehicles.size(); ++v) {
    if (!vehicles[v]) continue;
    const Inspected& inspected = *vehicles[v];
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

namespace {

/// The parts of all inspections of a log, one after the other, with their vehicles.
struct LoggedPart {
  std::size_t vehicle = 0;
  InspectionOutcome::Part part;
};

twin::SurfaceKind surface_kind_named(const std::string& name) {
  for (int i = 0; i <= static_cast<int>(twin::SurfaceKind::water); ++i)
    if (name == twin::name_of(static_cast<twin::SurfaceKind>(i)))
      return static_cast<twin::SurfaceKind>(i);
  refuse("the log has a surface of kind '" + name +
         "', which this version does not know; read it with the version that wrote it");
}

std::vector<LoggedPart> parts_in(const ingest::TrajectoryFile& log, std::size_t vehicles) {
  std::vector<LoggedPart> parts;
  const std::string text = log.attribute(inspection_attribute);
  if (text.empty()) return parts;
  try {
    for (const json& pair : json::parse(text)) {
      LoggedPart& logged = parts.emplace_back();
      logged.vehicle = pair.at("vehicle").get<std::size_t>();
      if (logged.vehicle >= vehicles) refuse("it is about a vehicle that the log does not have");
      InspectionOutcome::Part& part = logged.part;
      // What has no end is null in JSON.
      const auto detail_m = [&](const char* key) {
        return pair.contains(key) && pair.at(key).is_number()
                   ? pair.at(key).get<double>()
                   : std::numeric_limits<double>::infinity();
      };
      part.surface = pair.at("surface").get<std::string>();
      part.instrument = pair.at("instrument").get<std::string>();
      part.kind = surface_kind_named(pair.at("kind").get<std::string>());
      part.area_m2 = pair.at("area_m2").get<double>();
      part.seen_m2 = pair.at("seen_m2").get<double>();
      part.covered_m2 = pair.at("covered_m2").get<double>();
      part.asked = pair.at("done_at").get<double>();
      part.least_detail_m = detail_m("least_detail_m");
      part.median_detail_m = detail_m("median_detail_m");
    }
  } catch (const json::exception& error) {
    throw Error(ErrorKind::invalid_input, std::string("the attribute inspection of the log is "
                                                      "damaged (") +
                                              error.what() + "); make the log again");
  }
  return parts;
}

/// With all their digits: the attribute rounds.
void read_surfaces(const ingest::TrajectoryFile& log, std::vector<LoggedPart>& parts) {
  const TableReader table(log, "inspected_surface");
  const auto detail_m = [&](const char* column, std::size_t row) {
    const double found = table.number(column, row);
    return std::isfinite(found) ? found : std::numeric_limits<double>::infinity();
  };
  std::size_t rows = 0;
  table.for_each([&](std::size_t vehicle, std::size_t row) {
    if (row >= parts.size() || parts[row].vehicle != vehicle)
      table.refuse("does not fit the attribute inspection");
    InspectionOutcome::Part& part = parts[row].part;
    part.area_m2 = table.number("area", row);
    part.seen_m2 = table.number("seen_area", row);
    part.covered_m2 = table.number("covered_area", row);
    part.least_detail_m = detail_m("least_detail", row);
    part.median_detail_m = detail_m("median_detail", row);
    ++rows;
  });
  if (rows != parts.size()) table.refuse("does not fit the attribute inspection");
}

void read_covered(const ingest::TrajectoryFile& log, std::vector<LoggedPart>& parts) {
  const TrajectoryTable* patches = log.find_table("inspected_patches");
  const TableReader table(log, "inspected_patches");
  for (std::size_t row = 0; patches != nullptr && row < patches->rows(); ++row) {
    const std::size_t pair = table.whole("pair", row);
    if (pair >= parts.size()) table.refuse("has a patch of a pair that is not there");
    parts[pair].part.covered.push_back(table.number("covered", row) > 0.5);
  }
}

void read_scores(const ingest::TrajectoryFile& log, twin::RunAccount& account) {
  const TableReader table(log, "inspected"), kinds(log, "defect_kind");
  const auto outcome = [&](const TableReader& from, std::size_t vehicle) -> InspectionOutcome& {
    auto& inspection = account.vehicles[vehicle].inspection;
    if (!inspection) from.refuse("is about a vehicle that inspected nothing");
    return *inspection;
  };
  table.for_each([&](std::size_t vehicle, std::size_t row) {
    InspectionOutcome& out = outcome(table, vehicle);
    const auto maybe = [&](const char* column) {
      const double value = table.number(column, row);
      return std::isfinite(value) ? std::optional(value) : std::nullopt;
    };
    out.looks = table.whole("looks", row);
    out.rays = table.whole("rays", row);
    out.worked_s = table.number("worked", row);
    out.left = table.word("left", row);
    out.score.detection_rate = maybe("detection_rate");
    out.score.false_alarms_per_100_m2 = maybe("false_alarms_per_100_m2");
    out.score.size_error_rms_m = maybe("size_error_rms");
    out.score.size_error_relative_rms = maybe("size_error_relative_rms");
  });
  kinds.for_each([&](std::size_t vehicle, std::size_t row) {
    twin::DetectionScore& score = outcome(kinds, vehicle).score;
    const std::size_t kind = kinds.whole("kind", row);
    if (kind >= score.kinds.size()) kinds.refuse("has a kind of defect that is not there");
    twin::DetectionScore::OfKind& of = score.kinds[kind];
    of = {kinds.whole("planted", row), kinds.whole("found", row), kinds.whole("false_alarms", row)};
    score.all.planted += of.planted;
    score.all.found += of.found;
    score.all.false_alarms += of.false_alarms;
  });
}

/// Of logs without their scores.
void count_findings(const ingest::TrajectoryFile& log, const std::vector<LoggedPart>& parts,
                    twin::RunAccount& account) {
  const TrajectoryTable* findings = log.find_table("findings");
  const TableReader table(log, "findings");
  std::set<std::pair<std::size_t, double>> seen;
  for (std::size_t row = 0; findings != nullptr && row < findings->rows(); ++row) {
    const double pair = table.number("pair", row);
    if (!(pair >= 0 && pair < static_cast<double>(parts.size()))) continue;
    const std::size_t vehicle = parts[static_cast<std::size_t>(pair)].vehicle;
    twin::DetectionScore::OfKind& all = account.vehicles[vehicle].inspection->score.all;
    const std::size_t outcome = table.whole("outcome", row);
    const bool is_new = table.number("defect", row) < 0 ||
                        seen.emplace(vehicle, table.number("defect", row)).second;
    if (outcome == 1) {
      ++all.false_alarms;
    } else if (is_new) {  // else another instrument found it, too
      ++all.planted;
      all.found += outcome == 0 ? 1 : 0;
    }
  }
}

}  // namespace

void read_inspections(const ingest::TrajectoryFile& log, twin::RunAccount& account) {
  std::vector<LoggedPart> parts = parts_in(log, account.vehicles.size());
  if (parts.empty()) return;
  const bool has_scores = log.find_table("inspected") != nullptr;
  if (has_scores) read_surfaces(log, parts);
  read_covered(log, parts);
  for (const LoggedPart& logged : parts) {
    auto& inspection = account.vehicles[logged.vehicle].inspection;
    if (!inspection) inspection.emplace();
    inspection->parts.push_back(logged.part);
  }
  if (has_scores)
    read_scores(log, account);
  else
    count_findings(log, parts, account);
}

}  // namespace slackwater::api
