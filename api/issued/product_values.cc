#include "api/issued/product_values.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "api/issued/value_sheet.h"
#include "data/store/layout.h"
#include "data/store/proven_content.h"
#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/log.h"
#include "fields/geo/coverage.h"
#include "fields/interpolate/column_levels.h"
#include "fields/record/choose.h"
#include "ingest/cf/granule_file.h"
#include "ingest/pieces.h"

namespace slackwater::api {
namespace {

/// Cells this near are one: axes of single precision.
constexpr double same_cell_deg = 2e-5;

BoundingBox box_of(const ProductWindow& window) {
  return {window.west_deg, window.south_deg, window.east_deg, window.north_deg};
}

/// Means that only touch the window say nothing of it.
bool is_in(const TimeCell& cell, const ProductWindow& window) {
  if (cell.is_mean()) return cell.start < window.to && cell.end > window.from;
  return cell.start >= window.from && cell.start <= window.to;
}

/// How many quantities of a product a file holds.
std::size_t names_held(const StoredProduct& product, const store::GranuleRow& row) {
  const auto& names = row.standard_names;
  return static_cast<std::size_t>(std::count_if(
      product.standard_names.begin(), product.standard_names.end(), [&](const std::string& name) {
        return std::find(names.begin(), names.end(), name) != names.end();
      }));
}

/// ", e.g. to A/B": the last of the window that holds few enough files; empty where too many end
/// with it.
std::string range_that_fits(const std::vector<const store::GranuleRow*>& granules, UtcTime to) {
  std::vector<UtcTime> ends;
  ends.reserve(granules.size());
  for (const store::GranuleRow* row : granules) ends.push_back(*row->last_time);
  std::sort(ends.begin(), ends.end(), std::greater<>());
  const UtcTime from = ends[ProductView::most_files] + std::chrono::seconds(1);
  return from < to ? ", e.g. to " + format_utc(from) + "/" + format_utc(to) : std::string();
}

void add_near(std::vector<double>& sorted, double value, double same) {
  const auto next = std::lower_bound(sorted.begin(), sorted.end(), value - same);
  if (next == sorted.end() || *next > value + same) sorted.insert(next, value);
}

/// As the window counts it: of both ends of a whole turn the west.
double in_window(double longitude_deg, const ProductWindow& window) {
  const double middle = 0.5 * (window.west_deg + window.east_deg);
  return longitude_deg + 360.0 * std::ceil((middle - longitude_deg) / 360.0 - 0.5);
}

std::string run_of(const Origin& origin) {
  if (origin.status != DataStatus::forecast) return std::string(name_of(origin.status));
  if (!origin.reference_time) return "forecast";
  return "forecast of " + format_utc(*origin.reference_time);
}

double forecast_period_h(const Origin& origin, UtcTime time) {
  if (origin.status != DataStatus::forecast) return 0;
  return origin.reference_time ? hours_between(*origin.reference_time, time) : constants::nan;
}

double part_of(double value, std::size_t /*quantity*/) { return value; }
double part_of(Horizontal value, std::size_t quantity) {
  return quantity == 0 ? value.real() : value.imag();
}

const Column<double>& at_levels(const Column<double>& column, std::span<const double> /*levels*/) {
  return column;
}
VectorColumn at_levels(const VectorColumn& column, std::span<const double> levels_m) {
  if (levels_m.empty() || column.levels_m.empty()) return column;
  return at_depths(column, {levels_m.begin(), levels_m.end()});
}

/// Some times of one place.
struct Stretched {
  std::span<const UtcTime> times;
  std::span<const double> levels_m;
  std::size_t place = 0;
};

/// At a level of the product its own reason; between levels nobody knows one.
template <typename T>
SampleStatus why_absent(const Column<T>& column, std::size_t t, std::size_t k,
                        std::span<const double> levels_m) {
  if (levels_m.empty() || column.levels_m.empty()) return column.status[column.offset(t, 0)];
  for (std::size_t i = 0; i < column.levels(); ++i)
    if (std::abs(column.levels_m[i] - levels_m[k]) <= same_level_m)
      return column.status[column.offset(t, i)];
  return SampleStatus::missing;
}

/// A chosen series into the sheet, as `parts` quantities from `first` on.
/// @param is_leading  what is absent is counted by it
template <typename T>
void put_series(const Chosen<T>& chosen, bool on_land, std::size_t first, std::size_t parts,
                bool is_leading, const Stretched& wanted, ValueSheet& sheet) {
  std::vector<bool> has_row(wanted.times.size(), false);
  const auto column = at_levels(chosen.column, wanted.levels_m);
  ProductValues& out = sheet.out();
  const std::size_t period = out.value.size() - 1;
  const auto count = [&](std::size_t level, SampleStatus status) -> std::size_t& {
    return out.absent[level][static_cast<std::size_t>(status)];
  };
  for (std::size_t t = 0; t < chosen.column.times(); ++t) {
    const UtcTime centre = chosen.column.time[t].centre();
    const auto row = sheet.row(centre);
    const auto here = std::lower_bound(wanted.times.begin(), wanted.times.end(), centre);
    if (!row || here == wanted.times.end() || *here != centre) continue;
    has_row[static_cast<std::size_t>(here - wanted.times.begin())] = true;
    const Origin& origin = *chosen.origin[t];
    bool is_used = false;
    for (std::size_t k = 0; k < sheet.levels(); ++k) {
      const std::size_t at = column.offset(t, std::min(k, column.levels() - 1));
      if (!has_value(column.status[at])) {
        if (is_leading) ++count(k, why_absent(chosen.column, t, k, wanted.levels_m));
        continue;
      }
      is_used = true;
      for (std::size_t q = 0; q < parts; ++q)
        sheet.put(first + q, *row, k, wanted.place, part_of(column.value[at], q));
      sheet.put(period, *row, k, wanted.place, forecast_period_h(origin, centre));
    }
    if (!is_used) continue;
    out.runs.insert(run_of(origin));
    const TimeCell& cell = chosen.column.time[t];
    out.averaged = std::max(out.averaged, Duration(cell.end - cell.start));
    out.sources.insert(origin.sources.begin(), origin.sources.end());
    out.contains_stokes = out.contains_stokes || origin.contains_stokes;
  }
  if (!is_leading) return;
  for (const Stretch& stretch : chosen.stretches)
    out.most_members = std::max(out.most_members, stretch.members);
  const auto none = static_cast<std::size_t>(std::count(has_row.begin(), has_row.end(), false));
  const bool is_land = on_land && chosen.empty();
  for (std::size_t k = 0; k < sheet.levels(); ++k)
    count(k, is_land ? SampleStatus::land : SampleStatus::missing) += none;
}

Error cannot_be_read(const StoredProduct& product, const Error& why) {
  log_event(LogLevel::error, "stored product cannot be read",
            {{"product", product.product_id}, {"problem", why.message()}});
  return {ErrorKind::unavailable,
          "the stored files of this product cannot be read now; tell the operator, who finds them "
          "by `slackwater store check`"};
}

Choice grids_alone() {
  Choice choice;
  choice.only_grids = true;
  return choice;
}

/// What of a product is read around a place: of a vector both components, then scalars.
struct Read {
  const std::vector<VectorPiece>* vector = nullptr;  ///< null: it has none
  std::vector<std::vector<ScalarPiece>> scalars;
};

/// The first that there is decides which run speaks when, for all.
void put_place(const Read& read, const GeoPoint& point, const Stretched& wanted,
               ValueSheet& sheet) {
  VectorRecord vector;  // records outlive what was chosen from them
  std::vector<ScalarRecord> records;
  std::vector<Stretch> leading;
  std::size_t q = 0;
  if (read.vector != nullptr) {
    vector = record_at(*read.vector, point);
    const auto chosen = choose(vector, Knowledge{}, grids_alone());
    put_series(chosen, vector.on_land, q, vector_components, true, wanted, sheet);
    leading = chosen.stretches;
    q = vector_components;
  }
  records.reserve(read.scalars.size());
  for (const std::vector<ScalarPiece>& pieces : read.scalars) {
    records.push_back(record_at(pieces, point));
    Choice choice = grids_alone();
    if (!leading.empty()) choice.like = &leading;
    const Chosen<double> chosen = choose(records.back(), Knowledge{}, choice);
    put_series(chosen, records.back().on_land, q, 1, q == 0, wanted, sheet);
    if (q == 0) leading = chosen.stretches;
    ++q;
  }
}

}  // namespace

ProductView::ProductView(std::filesystem::path store, const StoredProduct& product,
                         const ProductWindow& window, std::size_t most)
    : store_(std::move(store)), product_(product), window_(window), most_read_(most) {
  const BoundingBox box = box_of(window);
  const ingest::CutOut cut = ingest::cut_around(box, window.from, window.to);
  for (const store::GranuleRow& row : product.granules) {
    if (*row.last_time < window.from || *row.first_time > window.to) continue;
    if (overlaps(row.bounds, widened(box, ingest::granule_margin_km))) granules_.push_back(&row);
  }
  if (granules_.size() > most_files) {
    throw Error(ErrorKind::usage,
                "found a query that reaches into " + std::to_string(granules_.size()) +
                    " stored files of the product; expected at most " + std::to_string(most_files) +
                    ": narrow datetime" + range_that_fits(granules_, window.to));
  }
  std::size_t unreadable = 0;
  const auto open = [&](const store::GranuleRow& row) {
    const ingest::GranuleFile file =
        ingest::GranuleFile::open(store::proven_content(store_, row.content_sha256));
    const Grid& grid = file.granule().grid;
    const std::size_t read = ingest::cells_read(grid, cut) * names_held(product, row);
    for (const TimeCell& cell : grid.time) {
      if (!is_in(cell, window)) continue;
      time_.push_back(cell);
      stored_[cell.centre()] += read;
    }
    for (const double level : grid.levels_m) add_near(levels_m_, level, same_level_m);
    for (const double y : grid.latitude_deg)
      if (y >= window.south_deg && y <= window.north_deg) add_near(latitude_deg_, y, same_cell_deg);
    for (const double x : grid.longitude_deg) {
      const double here = in_window(x, window);
      if (here >= window.west_deg && here <= window.east_deg)
        add_near(longitude_deg_, here, same_cell_deg);
    }
  };
  std::erase_if(granules_, [&](const store::GranuleRow* row) {
    if (store::content_fault(store_, row->content_sha256)) {
      ++damaged_;
      return true;
    }
    try {
      open(*row);
      return false;
    } catch (const Error& error) {
      log_event(LogLevel::warning, "stored file left out",
                {{"product", product_.product_id}, {"problem", error.message()}});
      ++unreadable;
      return true;
    }
  });
  damaged_ += unreadable;
  if (granules_.empty() && damaged_ > 0) {
    throw Error(ErrorKind::unavailable,
                "the stored files of this product cannot be read now; tell the operator, who finds "
                "them by `slackwater store check`");
  }
  std::sort(time_.begin(), time_.end(),
            [](const TimeCell& a, const TimeCell& b) { return a.centre() < b.centre(); });
  time_.erase(
      std::unique(time_.begin(), time_.end(),
                  [](const TimeCell& a, const TimeCell& b) { return a.centre() == b.centre(); }),
      time_.end());
}

ProductValues ProductView::values(std::span<const GeoPoint> places, std::span<const UtcTime> times,
                                  std::span<const double> levels_m, Levels which) const {
  if (product_.is_measured()) {
    try {
      return measured(times, levels_m);
    } catch (const Error& error) {
      throw cannot_be_read(product_, error);
    }
  }
  ProductValues out;
  const bool is_one_each = which == Levels::one_for_each;
  const std::size_t levels = is_one_each ? 1 : std::max<std::size_t>(1, levels_m.size());
  out.value.assign(product_.standard_names.size() + 1,
                   std::vector<double>(times.size() * levels * places.size(), constants::nan));
  out.absent.resize(levels);
  if (times.empty() || places.empty()) return out;
  for (const UtcTime time : times) {
    if (stored_.at(time) <= most_read_) continue;
    throw Error(ErrorKind::usage, "found a query around " + std::to_string(stored_.at(time)) +
                                      " values of the product at " + format_utc(time) +
                                      ", of all its runs; expected at most " +
                                      std::to_string(most_read_) + ": narrow the area");
  }
  const auto& names = product_.standard_names;
  ValueSheet sheet(out, times, levels, places.size());
  for (std::size_t first = 0, count = 0; first < times.size(); first += count) {
    std::size_t held = 0;
    for (count = 0; first + count < times.size(); ++count) {
      held += stored_.at(times[first + count]);
      if (count > 0 && held > read_at_once) break;
    }
    const auto part = times.subspan(first, count);
    const auto find = [&](const std::vector<std::string>& asked, const ingest::CutOut& window) {
      std::vector<ingest::GranuleEntry> found;
      for (const store::GranuleRow* row : granules_) {
        const bool is_wanted =
            std::any_of(asked.begin(), asked.end(), [&](const std::string& name) {
              return std::find(names.begin(), names.end(), name) != names.end() &&
                     std::find(row->standard_names.begin(), row->standard_names.end(), name) !=
                         row->standard_names.end();
            });
        if (!is_wanted || *row->last_time < window.from || *row->first_time > window.to) continue;
        found.push_back({row->id, row->source_sha256, row->product_id, row->standard_names,
                         store::proven_content(store_, row->content_sha256), row->ingested_at,
                         row->published_at});
      }
      return found;
    };
    const bool is_vector = product_.kind != ProductKind::waves;
    const std::size_t first_scalar = is_vector ? vector_components : 0;
    // What is given beside a vector (gusts, at 10 m) has one level.
    const bool has_scalars = !is_vector || levels == 1;
    SitePieces pieces;
    Read read;
    try {
      const ingest::CutOut cut = ingest::cut_around(box_of(window_), part.front(), part.back());
      if (is_vector) {
        pieces = ingest::pieces_of(cut, find);
        read.vector = product_.kind == ProductKind::currents ? &pieces.current : &pieces.wind;
      }
      if (has_scalars) {
        read.scalars = ingest::scalar_pieces_of(
            cut, {names.begin() + static_cast<std::ptrdiff_t>(first_scalar), names.end()}, find);
      }
    } catch (const Error& error) {
      throw cannot_be_read(product_, error);
    }
    for (std::size_t p = 0; p < places.size(); ++p) {
      const Stretched wanted{part, is_one_each ? levels_m.subspan(p, 1) : levels_m, p};
      put_place(read, places[p], wanted, sheet);
    }
  }
  return out;
}

}  // namespace slackwater::api
