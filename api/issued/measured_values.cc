#include <algorithm>
#include <cmath>

#include "api/issued/value_sheet.h"
#include "data/store/proven_content.h"
#include "fields/base/constants.h"
#include "ingest/cf/granule_file.h"

namespace slackwater::api {
namespace {

/// What of an instrument's file lies in a stretch of time: the first of its times, and how many.
std::pair<std::size_t, std::size_t> times_within(const std::vector<TimeCell>& all, UtcTime from,
                                                 UtcTime to) {
  const auto first = std::find_if(all.begin(), all.end(),
                                  [&](const TimeCell& cell) { return cell.centre() >= from; });
  const auto end =
      std::find_if(first, all.end(), [&](const TimeCell& cell) { return cell.centre() > to; });
  return {static_cast<std::size_t>(first - all.begin()), static_cast<std::size_t>(end - first)};
}

/// Where each level of a file stands among those that are asked for; nothing where it does not.
std::vector<std::optional<std::size_t>> places_of(const std::vector<double>& file_m,
                                                  std::span<const double> asked_m) {
  if (file_m.empty()) return {0};
  std::vector<std::optional<std::size_t>> places;
  for (const double level : file_m) {
    const auto at = std::find_if(asked_m.begin(), asked_m.end(), [&](double asked) {
      return std::abs(asked - level) <= same_level_m;
    });
    places.push_back(at == asked_m.end()
                         ? std::nullopt
                         : std::optional(static_cast<std::size_t>(at - asked_m.begin())));
  }
  return places;
}

/// Good values alone; `reason` has, by row and level, why there is none.
void put_measured(const ingest::GranuleFile& file, const std::string& name, std::size_t quantity,
                  ValueSheet& sheet, std::span<const UtcTime> wanted,
                  std::span<const double> levels_m, std::vector<SampleStatus>& reason) {
  const Grid& grid = file.granule().grid;
  const auto places = places_of(grid.levels_m, levels_m);
  const auto within = times_within(grid.time, wanted.front(), wanted.back());
  const std::size_t end = within.first + within.second;
  const std::size_t at_once = std::max<std::size_t>(1, read_at_once / grid.levels());
  for (std::size_t first = within.first; first < end; first += at_once) {
    const std::size_t times = std::min(at_once, end - first);
    const GriddedField field = file.read(name, first, times, 0, 1, 0, 1);
    for (std::size_t t = 0; t < times; ++t) {
      const auto row = sheet.row(grid.time[first + t].centre());
      if (!row) continue;
      for (std::size_t k = 0; k < places.size(); ++k) {
        if (!places[k]) continue;
        const std::size_t at = t * places.size() + k;
        SampleStatus status = field.status.empty() ? SampleStatus::ok : field.status[at];
        const double value = field.values[at];
        if (status == SampleStatus::ok && std::isnan(value)) status = SampleStatus::missing;
        if (status == SampleStatus::ok) {
          sheet.put(quantity, *row, *places[k], 0, value);
        } else if (status != SampleStatus::missing) {
          reason[*row * sheet.levels() + *places[k]] = status;
        }
      }
    }
  }
}

}  // namespace

ProductValues ProductView::measured(std::span<const UtcTime> times,
                                    std::span<const double> levels_m) const {
  ProductValues out;
  const std::size_t levels = std::max<std::size_t>(1, levels_m.size());
  const auto& names = product_.standard_names;
  out.value.assign(names.size() + 1, std::vector<double>(times.size() * levels, constants::nan));
  out.absent.resize(levels);
  if (times.empty()) return out;
  ValueSheet sheet(out, times, levels, 1);
  std::vector<SampleStatus> reason(times.size() * levels, SampleStatus::missing);
  std::vector<const store::GranuleRow*> rows = granules_;
  std::sort(rows.begin(), rows.end(), [](const auto* a, const auto* b) { return a->id < b->id; });
  for (const store::GranuleRow* row : rows) {
    if (*row->last_time < times.front() || *row->first_time > times.back()) continue;
    const ingest::GranuleFile file =
        ingest::GranuleFile::open(store::proven_content(store_, row->content_sha256));
    for (std::size_t q = 0; q < names.size(); ++q)
      if (std::find(row->standard_names.begin(), row->standard_names.end(), names[q]) !=
          row->standard_names.end())
        put_measured(file, names[q], q, sheet, times, levels_m, reason);
    for (const TimeCell& cell : file.granule().grid.time)
      if (sheet.row(cell.centre()))
        out.averaged = std::max(out.averaged, Duration(cell.end - cell.start));
    out.sources.insert(row->source_sha256);
    out.contains_stokes = out.contains_stokes || row->contains_stokes;
  }
  out.runs.insert(std::string(name_of(DataStatus::observation)));
  // Half a vector is none.
  const bool is_vector = product_.kind != ProductKind::waves;
  for (std::size_t i = 0; i < reason.size(); ++i) {
    if (is_vector && std::isnan(out.value[0][i] + out.value[1][i]))
      out.value[0][i] = out.value[1][i] = constants::nan;
    if (std::isnan(out.value[0][i])) ++out.absent[i % levels][static_cast<std::size_t>(reason[i])];
  }
  return out;
}

}  // namespace slackwater::api
