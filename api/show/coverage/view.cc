#include "api/show/coverage/view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "fields/base/turn.h"

namespace slackwater::api {
namespace {

using ingest::TrajectoryFile;
using ingest::TrajectoryTable;
using nlohmann::json;

[[noreturn]] void refuse(const std::string& found, const std::string& expected) {
  throw Error(ErrorKind::invalid_input, "the inspection in the log is damaged: found " + found +
                                            ", expected " + expected +
                                            "; run `slackwater simulate` again");
}

/// A key of one entry of the attribute.
const json& at(const json& entry, const char* key) {
  if (!entry.is_object() || !entry.contains(key))
    refuse("an entry without '" + std::string(key) + "'", "one for each surface and instrument");
  return entry[key];
}

double number_at(const json& entry, const char* key, double least, double most = 1e12) {
  const json& value = at(entry, key);
  if (value.is_number() && value.get<double>() >= least && value.get<double>() <= most)
    return value.get<double>();
  refuse(
      "'" + std::string(key) + "': " + value.dump(-1, ' ', false, json::error_handler_t::replace),
      formatted("a number of {:g} to {:g}", least, most));
}

std::optional<double> optional_at(const json& entry, const char* key) {
  if (at(entry, key).is_null()) return std::nullopt;
  return number_at(entry, key, 0);
}

std::string text_at(const json& entry, const char* key) {
  const json& value = at(entry, key);
  if (!value.is_string()) refuse("'" + std::string(key) + "' that is no text", "a text");
  return value.get<std::string>();
}

CoverageSheet sheet_of(const json& entry) {
  CoverageSheet sheet;
  sheet.width_m = number_at(entry, "width_m", 1e-6);
  sheet.height_m = number_at(entry, "height_m", 1e-6);
  const json& all_round = at(entry, "is_all_round");
  if (!all_round.is_boolean())
    refuse("'is_all_round' that is neither true nor false", "one of them");
  sheet.is_all_round = all_round.get<bool>();
  sheet.along = text_at(entry, "along");
  sheet.down = text_at(entry, "down");
  sheet.first_bearing_deg = number_at(entry, "first_bearing_deg", -360, 360);
  sheet.top_depth_m = number_at(entry, "top_z_m", -1e5, 1e5);
  return sheet;
}

InspectionCoverage pair_of(const json& entry, const TrajectoryFile& log) {
  InspectionCoverage pair;
  const double vehicle = number_at(entry, "vehicle", 0, static_cast<double>(log.names.size()) - 1);
  pair.vehicle = log.names[static_cast<std::size_t>(vehicle)];
  pair.surface = text_at(entry, "surface");
  pair.kind = text_at(entry, "kind");
  pair.instrument = text_at(entry, "instrument");
  pair.asked_detail_m = number_at(entry, "detail_m", 0);
  pair.asked_incidence_deg = number_at(entry, "incidence_deg", 0, 180);
  pair.asked_looks = static_cast<int>(number_at(entry, "looks", 0, 1e6));
  pair.done_at = number_at(entry, "done_at", 0, 1);
  pair.sheet = sheet_of(at(entry, "sheet"));
  pair.area_m2 = number_at(entry, "area_m2", 1e-9);
  // Sums of the same patches in another order may differ in their last digits.
  pair.seen_m2 = std::min(pair.area_m2, number_at(entry, "seen_m2", 0, pair.area_m2 * (1 + 1e-6)));
  pair.covered_m2 =
      std::min(pair.seen_m2, number_at(entry, "covered_m2", 0, pair.seen_m2 * (1 + 1e-6)));
  pair.least_detail_m = optional_at(entry, "least_detail_m");
  pair.median_detail_m = optional_at(entry, "median_detail_m");
  return pair;
}

/// The rows of a table, with its columns by name.
class Rows {
 public:
  explicit Rows(const TrajectoryTable& table) : table_(table) {}

  [[nodiscard]] std::size_t count() const { return table_.rows(); }
  /// NaN or not.
  [[nodiscard]] const std::vector<double>& column(const char* name) const {
    const std::vector<double>* values = table_.column(name);
    if (values == nullptr || values->size() != table_.rows())
      refuse("table '" + table_.name + "' without a whole column '" + name + "'", "one");
    return *values;
  }
  /// Of a row: a whole number below `count`.
  [[nodiscard]] std::size_t whole(const char* name, std::size_t row, std::size_t below) const {
    const double value = column(name)[row];
    if (!(value >= 0 && value < static_cast<double>(below)) || value != std::floor(value))
      refuse(place(name, row, value), formatted("a whole number below {}", below));
    return static_cast<std::size_t>(value);
  }
  [[nodiscard]] double finite(const char* name, std::size_t row, double least = -1e12) const {
    const double value = column(name)[row];
    if (!std::isfinite(value) || value < least)
      refuse(place(name, row, value), formatted("a number of at least {:g}", least));
    return value;
  }
  /// A place or a direction of three columns.
  [[nodiscard]] Vector3<Enu> triple(const std::array<const char*, 3>& names,
                                    std::size_t row) const {
    return {finite(names[0], row), finite(names[1], row), finite(names[2], row)};
  }

 private:
  [[nodiscard]] std::string place(const char* name, std::size_t row, double value) const {
    return formatted("{} in row {} of column '{}' of table '{}'", value, row + 1, name,
                     table_.name);
  }
  const TrajectoryTable& table_;
};

constexpr std::array<const char*, 3> place_columns{"x", "y", "z"};
constexpr std::array<const char*, 3> normal_columns{"normal_x", "normal_y", "normal_z"};
constexpr std::array<const char*, 3> true_columns{"true_x", "true_y", "true_z"};

CoveragePatch patch_of(const Rows& rows, std::size_t i) {
  CoveragePatch patch;
  patch.along_m = rows.finite("along", i);
  patch.down_m = rows.finite("down", i);
  patch.width_m = rows.finite("width", i, 0);
  patch.height_m = rows.finite("height", i, 0);
  patch.centre_m = rows.triple(place_columns, i);
  patch.normal = rows.triple(normal_columns, i);
  patch.area_m2 = rows.finite("area", i, 0);
  const bool is_seen = rows.finite("looks", i, 0) > 0;
  const bool is_covered = rows.whole("covered", i, 2) == 1;
  if (is_covered && !is_seen)
    refuse(formatted("a covered patch without a look in row {}", i + 1), "a look at least");
  patch.state = is_covered ? PatchState::covered
                : is_seen  ? PatchState::seen_poorly
                           : PatchState::unseen;
  const double nothing = constants::nan;
  // Light may have been too poor to make out anything: a detail without bound.
  const double detail_m = rows.column("detail")[i];
  if (is_seen && !(detail_m >= 0))
    refuse(formatted("detail {} of a patch that was seen, row {}", detail_m, i + 1), "a length");
  patch.detail_m = is_seen ? detail_m : nothing;
  patch.incidence_deg = is_seen ? rows.finite("incidence", i, 0) : nothing;
  patch.range_m = is_seen ? rows.finite("range", i, 0) : nothing;
  patch.t_s = is_seen ? rows.finite("time", i, 0) : nothing;
  return patch;
}

constexpr std::size_t outcomes = 5;

Finding finding_of(const Rows& rows, std::size_t i) {
  const double nothing = constants::nan;
  Finding finding;
  finding.kind = static_cast<twin::DefectKind>(rows.whole("kind", i, twin::defect_kinds));
  finding.outcome = static_cast<FindingOutcome>(rows.whole("outcome", i, outcomes));
  finding.along_m = rows.finite("along", i);
  finding.down_m = rows.finite("down", i);
  const bool is_reported = finding.is_reported();
  const bool is_there = finding.outcome != FindingOutcome::false_alarm;
  const Vector3<Enu> nowhere{nothing, nothing, nothing};
  finding.reported_m = is_reported ? rows.triple(place_columns, i) : nowhere;
  finding.size_m = is_reported ? rows.finite("size", i, 0) : nothing;
  finding.severity = is_reported ? rows.column("severity")[i] : nothing;  // not all measure it
  finding.t_s = is_reported ? rows.finite("time", i, 0) : nothing;
  finding.detail_m = is_reported ? rows.finite("detail", i, 0) : nothing;
  finding.true_m = is_there ? rows.triple(true_columns, i) : nowhere;
  finding.true_size_m = is_there ? rows.finite("true_size", i, 0) : nothing;
  finding.true_severity = is_there ? rows.finite("true_severity", i) : nothing;
  return finding;
}

}  // namespace

double CoverageSheet::bearing_deg(double along_m) const noexcept {
  return compass_deg(first_bearing_deg + 360 * along_m / width_m);
}

const char* words_of(FindingOutcome outcome) noexcept {
  constexpr const char* words[] = {"found", "false alarm", "missed: never seen",
                                   "missed: seen too poorly", "missed: overlooked"};
  return words[static_cast<std::size_t>(outcome)];
}

std::string words_of(twin::DefectKind kind) {
  std::string words = twin::name_of(kind);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

std::array<double, patch_states> InspectionCoverage::shares() const noexcept {
  return {covered_m2 / area_m2, (seen_m2 - covered_m2) / area_m2, (area_m2 - seen_m2) / area_m2};
}

const CoveragePatch* InspectionCoverage::nearest_patch(const Vector3<Enu>& place_m) const noexcept {
  const CoveragePatch* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const CoveragePatch& patch : patches) {
    const Vector3<Enu> off = patch.centre_m - place_m;
    const double square = off.x() * off.x() + off.y() * off.y() + off.z() * off.z();
    if (square >= least) continue;
    least = square;
    nearest = &patch;
  }
  return nearest;
}

std::vector<InspectionCoverage> coverage_in(const TrajectoryFile& log) {
  const std::string text = log.attribute("inspection");
  if (text.empty()) return {};
  const json entries = json::parse(text, nullptr, false);
  if (!entries.is_array()) refuse("an attribute 'inspection' that is no JSON list", "one");
  std::vector<InspectionCoverage> pairs;
  for (const json& entry : entries) pairs.push_back(pair_of(entry, log));
  if (pairs.empty()) return {};
  const TrajectoryTable* patches = log.find_table("inspected_patches");
  if (patches == nullptr) refuse("no table 'inspected_patches'", "the patches of each surface");
  const Rows patch_rows(*patches);
  for (std::size_t i = 0; i < patch_rows.count(); ++i)
    pairs[patch_rows.whole("pair", i, pairs.size())].patches.push_back(patch_of(patch_rows, i));
  // A table without rows is not written.
  if (const TrajectoryTable* findings = log.find_table("findings")) {
    const Rows rows(*findings);
    for (std::size_t i = 0; i < rows.count(); ++i)
      pairs[rows.whole("pair", i, pairs.size())].findings.push_back(finding_of(rows, i));
  }
  return pairs;
}

}  // namespace slackwater::api
