#include "fields/interpolate/column_of_field.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"
#include "fields/interpolate/stencil.h"

namespace slackwater {
namespace {

/// What interpolation needs to know of a field: whether a cell has a value, and what it is.
template <typename T>
struct Cells {
  const Grid& grid;
  bool (*valid)(const Cells&, std::size_t offset);
  T (*value)(const Cells&, std::size_t offset);
  SampleStatus (*status)(const Cells&, std::size_t offset);
  const GriddedField* first = nullptr;
  const GriddedField* second = nullptr;
};

SampleStatus own_status(const GriddedField& field, std::size_t offset) {
  if (!field.status.empty()) return field.status[offset];
  return std::isnan(field.values[offset]) ? SampleStatus::missing : SampleStatus::ok;
}

/// The worse of two statuses: a vector is as good as its worse component.
SampleStatus worse(SampleStatus a, SampleStatus b) {
  if (!has_value(a)) return a;
  if (!has_value(b)) return b;
  return std::max(a, b);
}

template <typename T>
Column<T> interpolate(const Cells<T>& cells, const GeoPoint& point, DataStatus status_of_file) {
  const Grid& grid = cells.grid;
  Column<T> column;
  column.point = point;
  column.time = grid.time;
  column.vertical = grid.vertical;
  column.levels_m = grid.levels_m;
  const std::size_t times = grid.times();
  if (grid.time.empty()) column.time.assign(1, TimeCell{});
  column.source.assign(times, status_of_file);
  column.value.assign(times * grid.levels(), T{});
  column.status.assign(times * grid.levels(), SampleStatus::outside_area);
  const auto stencil = bilinear_stencil(grid, point);
  if (!stencil) return column;

  bool wet_above = false;
  // Depths run downwards from index 0; heights and surface fields have no bed below them.
  for (std::size_t k = 0; k < grid.levels(); ++k) {
    HorizontalStencil wet;
    double total = 0;
    for (std::size_t c = 0; c < stencil->count; ++c) {
      const auto& corner = stencil->corners[c];
      bool ever = false;
      for (std::size_t t = 0; t < times && !ever; ++t) {
        ever = cells.valid(cells, grid.offset(t, k, corner.row, corner.column));
      }
      if (ever) {
        wet.corners[wet.count++] = corner;
        total += corner.weight;
      }
    }
    for (std::size_t t = 0; t < times; ++t) {
      const std::size_t place = column.offset(t, k);
      if (wet.count == 0) {
        // A series knows why its values are missing; a mask tells land from bed by the water above.
        const auto& corner = stencil->corners[0];
        const SampleStatus own = cells.status(cells, grid.offset(t, k, corner.row, corner.column));
        column.status[place] = own != SampleStatus::missing ? own
                               : wet_above                  ? SampleStatus::below_bed
                                                            : SampleStatus::land;
        continue;
      }
      T sum{};
      SampleStatus status = SampleStatus::ok;
      for (std::size_t c = 0; c < wet.count; ++c) {
        const auto& corner = wet.corners[c];
        const std::size_t offset = grid.offset(t, k, corner.row, corner.column);
        status = worse(status, cells.status(cells, offset));
        if (!has_value(status)) break;
        sum += (corner.weight / total) * cells.value(cells, offset);
      }
      column.status[place] = status;
      if (has_value(status)) column.value[place] = sum;
    }
    wet_above = wet_above || wet.count > 0;
  }
  return column;
}

}  // namespace

VectorColumn column_of(const GriddedField& east, const GriddedField& north, const GeoPoint& point,
                       DataStatus status_of_file) {
  expects(east.grid == north.grid, "the components of a vector share a grid");
  const Cells<Horizontal> cells{
      east.grid,
      [](const Cells<Horizontal>& c, std::size_t o) {
        return has_value(worse(own_status(*c.first, o), own_status(*c.second, o)));
      },
      [](const Cells<Horizontal>& c, std::size_t o) {
        return Horizontal(static_cast<double>(c.first->values[o]),
                          static_cast<double>(c.second->values[o]));
      },
      [](const Cells<Horizontal>& c, std::size_t o) {
        return worse(own_status(*c.first, o), own_status(*c.second, o));
      },
      &east,
      &north};
  return interpolate(cells, point, status_of_file);
}

ScalarColumn column_of(const GriddedField& field, const GeoPoint& point,
                       DataStatus status_of_file) {
  const auto valid = [](const auto& c, std::size_t o) {
    return has_value(own_status(*c.first, o));
  };
  const auto status = [](const auto& c, std::size_t o) { return own_status(*c.first, o); };
  if (field.unit != "degree") {
    const Cells<double> cells{field.grid,
                              valid,
                              [](const Cells<double>& c, std::size_t o) {
                                return static_cast<double>(c.first->values[o]);
                              },
                              status,
                              &field,
                              nullptr};
    return interpolate(cells, point, status_of_file);
  }
  const Cells<Horizontal> cells{field.grid,
                                valid,
                                [](const Cells<Horizontal>& c, std::size_t o) {
                                  return vector_to_direction(
                                      1.0, static_cast<double>(c.first->values[o]));
                                },
                                status,
                                &field,
                                nullptr};
  const VectorColumn directions = interpolate(cells, point, status_of_file);
  ScalarColumn column;
  column.point = directions.point;
  column.time = directions.time;
  column.vertical = directions.vertical;
  column.levels_m = directions.levels_m;
  column.status = directions.status;
  column.source = directions.source;
  column.value.resize(directions.value.size());
  for (std::size_t i = 0; i < column.value.size(); ++i) {
    column.value[i] = to_direction_deg(directions.value[i]);
    // Opposed directions cancel: no mean direction exists.
    if (has_value(column.status[i]) && std::abs(directions.value[i]) < 1e-6) {
      column.status[i] = SampleStatus::missing;
    }
  }
  return column;
}

}  // namespace slackwater
