#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/base/check.h"
#include "fields/base/error.h"
#include "ingest/cf/granule_file.h"
#include "ingest/cf/granule_layout.h"
#include "ingest/netcdf/file.h"
#include "ingest/netcdf/writeback.h"

namespace slackwater::ingest {
namespace {

using netcdf::Type;
using netcdf::Writer;

constexpr float no_float = std::numeric_limits<float>::quiet_NaN();

double seconds_of(UtcTime time) {
  return static_cast<double>(time.time_since_epoch().count()) / 1000.0;
}

/// A granule's content file while it is being defined.
struct Definition {
  Writer& writer;
  const Granule& granule;
  GranuleLayout layout;
  std::vector<int> dimensions;
  bool has_means = false;
  int time = -1, bounds = -1, level = -1, latitude = -1, longitude = -1;

  void axes() {
    const Grid& grid = granule.grid;
    has_means = std::any_of(grid.time.begin(), grid.time.end(),
                            [](const TimeCell& cell) { return cell.is_mean(); });
    if (layout.has_time) {
      const int dimension = writer.dimension("time", grid.time.size());
      dimensions.push_back(dimension);
      time = writer.variable("time", Type::float64, {dimension});
      writer.attribute(time, "standard_name", "time");
      writer.attribute(time, "long_name",
                       has_means ? "centre of the interval of the mean" : "valid time");
      writer.attribute(time, "axis", "T");
      writer.attribute(time, "units", "seconds since 1970-01-01 00:00:00");
      writer.attribute(time, "calendar", "proleptic_gregorian");
      if (has_means) {
        writer.attribute(time, "bounds", "time_bnds");
        bounds =
            writer.variable("time_bnds", Type::float64, {dimension, writer.dimension("bnds", 2)});
      }
    }
    if (layout.has_level) {
      const std::string name = level_name(grid.vertical);
      const bool up = grid.vertical == VerticalKind::height_m;
      const int dimension = writer.dimension(name, grid.levels());
      dimensions.push_back(dimension);
      level = writer.variable(name, Type::float64, {dimension});
      writer.attribute(level, "standard_name", name);
      writer.attribute(level, "long_name",
                       up ? "height above mean sea level" : "depth below mean sea level");
      writer.attribute(level, "units", "m");
      writer.attribute(level, "positive", up ? "up" : "down");
      writer.attribute(level, "axis", "Z");
    }
    latitude = horizontal("latitude", "degrees_north", "Y", grid.rows());
    longitude = horizontal("longitude", "degrees_east", "X", grid.columns());
  }

  int horizontal(const std::string& name, const std::string& unit, const std::string& axis,
                 std::size_t length) {
    const int dimension = writer.dimension(name, length);
    dimensions.push_back(dimension);
    const int id = writer.variable(name, Type::float64, {dimension});
    writer.attribute(id, "standard_name", name);
    writer.attribute(id, "long_name", name);
    writer.attribute(id, "units", unit);
    writer.attribute(id, "axis", axis);
    return id;
  }

  int values(const GranuleVariable& variable) {
    const int id = writer.variable(variable.standard_name, Type::float32, dimensions,
                                   {layout.chunks(), 0, static_cast<double>(no_float)});
    writer.attribute(id, "standard_name", variable.standard_name);
    writer.attribute(id, "long_name", long_name(variable));
    writer.attribute(id, "units", variable.unit);
    writer.attribute(id, "source_name", variable.source_name);
    if (layout.has_time)
      writer.attribute(id, "cell_methods", has_means ? "time: mean" : "time: point");
    if (variable.contains_stokes) writer.attribute(id, "contains_stokes", "true");
    if (variable.has_tide)
      writer.attribute(id, "contains_tide", *variable.has_tide ? "true" : "false");
    if (variable.has_status)
      writer.attribute(id, "ancillary_variables", variable.standard_name + "_status");
    return id;
  }

  static std::string long_name(const GranuleVariable& variable) {
    std::string words = variable.standard_name;
    std::replace(words.begin(), words.end(), '_', ' ');
    return variable.contains_stokes ? words + ", Stokes drift included" : words;
  }

  int status(const GranuleVariable& variable) {
    if (!variable.has_status) return -1;
    const int id = writer.variable(variable.standard_name + "_status", Type::uint8, dimensions,
                                   {layout.chunks(), 0, {}});
    std::vector<double> flags;
    std::string meanings;
    for (int flag = 0; flag <= static_cast<int>(SampleStatus::suspect); ++flag) {
      flags.push_back(flag);
      if (!meanings.empty()) meanings += ' ';
      meanings += name_of(static_cast<SampleStatus>(flag));
    }
    writer.attribute(id, "standard_name", "status_flag");
    writer.attribute(id, "long_name", "status of " + long_name(variable));
    writer.attribute(id, "flag_values", flags, Type::uint8);
    writer.attribute(id, "flag_meanings", meanings);
    return id;
  }

  void global() {
    const auto text = [&](const char* name, const std::string& value) {
      if (!value.empty()) writer.attribute(Writer::global, name, value);
    };
    text("Conventions", "CF-1.8");
    text("title", granule.product_id + " as stored by Slackwater");
    text("institution", "Slackwater");
    text("source", granule.product_id);
    text("references", granule.attribution);
    text("attribution", granule.attribution);
    text("product", granule.product_id);
    text("dataset", granule.dataset_id);
    if (granule.is_regional) text("region", "regional");
    text("status", std::string(name_of(granule.status)));
    if (granule.reference_time) text("reference_time", format_utc(*granule.reference_time));
    if (granule.published_after > Duration(0))
      writer.attribute(Writer::global, "published_after_h",
                       hours_between(UtcTime{}, UtcTime{} + granule.published_after));
    if (granule.ensemble_member)
      writer.attribute(Writer::global, "ensemble_member", *granule.ensemble_member);
    if (granule.is_point_series) text("featureType_of_source", "point series");
    text("station", granule.station);
    if (granule.water_depth_m)
      writer.attribute(Writer::global, "water_depth_m", *granule.water_depth_m);
    if (granule.stated_error_m_s)
      writer.attribute(Writer::global, "stated_error_m_s", *granule.stated_error_m_s);
  }

  void write_axes() {
    const Grid& grid = granule.grid;
    if (time >= 0) {
      std::vector<double> centres;
      std::vector<double> edges;
      for (const TimeCell& cell : grid.time) {
        centres.push_back(seconds_of(cell.centre()));
        edges.push_back(seconds_of(cell.start));
        edges.push_back(seconds_of(cell.end));
      }
      writer.write_all(time, centres);
      if (bounds >= 0) writer.write_all(bounds, edges);
    }
    if (level >= 0) writer.write_all(level, grid.levels_m);
    writer.write_all(latitude, grid.latitude_deg);
    writer.write_all(longitude, grid.longitude_deg);
  }
};

}  // namespace

struct GranuleWriter::State {
  Writer writer;
  GranuleLayout layout;
  std::vector<int> values;
  std::vector<int> status;
  std::vector<float> chunk;  ///< one chunk, reused
  netcdf::Writeback writeback;

  void put_chunk(int variable, std::array<std::size_t, 4> at, std::array<std::size_t, 4> count,
                 std::size_t first_time, std::size_t first_row, std::size_t rows,
                 std::span<const float> block);
};

void GranuleWriter::State::put_chunk(int variable, std::array<std::size_t, 4> at,
                                     std::array<std::size_t, 4> count, std::size_t first_time,
                                     std::size_t first_row, std::size_t rows,
                                     std::span<const float> block) {
  chunk.resize(count[0] * count[1] * count[2] * count[3]);
  float* out = chunk.data();
  bool empty = true;
  for (std::size_t t = 0; t < count[0]; ++t) {
    for (std::size_t k = 0; k < count[1]; ++k) {
      for (std::size_t j = 0; j < count[2]; ++j) {
        const std::size_t line =
            ((at[0] + t - first_time) * layout.levels + k) * rows + at[2] + j - first_row;
        const float* in = block.data() + line * layout.columns + at[3];
        for (std::size_t i = 0; i < count[3]; ++i) {
          out[i] = in[i];
          empty &= std::isnan(in[i]);
        }
        out += count[3];
      }
    }
  }
  if (empty) return;
  writer.write(variable, layout.present(at), layout.present(count), std::span<const float>(chunk));
  writeback.wrote(chunk.size() * sizeof(float));
}

GranuleWriter::GranuleWriter(const std::filesystem::path& file, const Granule& granule) {
  expect_canonical(granule.grid);
  expects(!granule.variables.empty(), "a granule holds at least one variable");
  state_ = std::unique_ptr<State>(new State{
      Writer::create(file), GranuleLayout::of(granule.grid), {}, {}, {}, netcdf::Writeback(file)});
  Definition definition{state_->writer, granule, state_->layout, {}};
  definition.axes();
  for (const GranuleVariable& variable : granule.variables) {
    state_->values.push_back(definition.values(variable));
    state_->status.push_back(definition.status(variable));
  }
  definition.global();
  state_->writer.end_definitions();
  definition.write_axes();
}

GranuleWriter::~GranuleWriter() = default;

GranuleWriter::Block GranuleWriter::block() const noexcept {
  const GranuleLayout& layout = state_->layout;
  const std::size_t band =
      layout.chunk_times * layout.levels * layout.chunk_rows * layout.columns * sizeof(float);
  const std::size_t bands = std::max<std::size_t>(1, GranuleLayout::block_bytes / band);
  return {layout.chunk_times, std::min(layout.rows, bands * layout.chunk_rows)};
}

void GranuleWriter::put(std::size_t variable, std::size_t first_time, std::size_t times,
                        std::size_t first_row, std::size_t rows, std::span<const float> values) {
  const GranuleLayout& layout = state_->layout;
  expects(variable < state_->values.size(), "put: a variable of the granule");
  expects(first_time + times <= layout.times && first_row + rows <= layout.rows,
          "put: inside the granule");
  expects(values.size() == times * layout.levels * rows * layout.columns, "put: a whole block");
  const auto next = [](std::size_t at, std::size_t chunk) { return (at / chunk + 1) * chunk; };
  for (std::size_t t = first_time; t < first_time + times;) {
    const std::size_t t_end = std::min(next(t, layout.chunk_times), first_time + times);
    for (std::size_t j = first_row; j < first_row + rows;) {
      const std::size_t j_end = std::min(next(j, layout.chunk_rows), first_row + rows);
      for (std::size_t i = 0; i < layout.columns; i += layout.chunk_columns) {
        const std::size_t columns = std::min(layout.chunk_columns, layout.columns - i);
        state_->put_chunk(state_->values[variable], {t, 0, j, i},
                          {t_end - t, layout.levels, j_end - j, columns}, first_time, first_row,
                          rows, values);
      }
      j = j_end;
    }
    t = t_end;
  }
}

void GranuleWriter::put_status(std::size_t variable, std::size_t first_time, std::size_t times,
                               std::span<const SampleStatus> status) {
  const GranuleLayout& layout = state_->layout;
  expects(variable < state_->status.size() && state_->status[variable] >= 0,
          "put_status: a variable with status");
  expects(first_time + times <= layout.times, "put_status: inside the granule");
  expects(status.size() == times * layout.levels * layout.rows * layout.columns,
          "put_status: a whole block");
  std::vector<float> flags(status.size());
  std::transform(status.begin(), status.end(), flags.begin(),
                 [](SampleStatus flag) { return static_cast<float>(flag); });
  state_->writer.write(state_->status[variable], layout.present({first_time, 0, 0, 0}),
                       layout.present({times, layout.levels, layout.rows, layout.columns}),
                       std::span<const float>(flags));
}

void GranuleWriter::finish() { state_->writer.close(); }

}  // namespace slackwater::ingest
