#include "ingest/cf/granule_file.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/error.h"
#include "ingest/cf/granule_layout.h"
#include "ingest/netcdf/file.h"

namespace slackwater::ingest {
namespace {

[[noreturn]] void refuse_file(const netcdf::File& file, const std::string& why) {
  throw Error(ErrorKind::invalid_input, file.path().string() +
                                            ": not a content file of the store: " + why +
                                            "; run `slackwater store check`");
}

const netcdf::Variable& need(const netcdf::File& file, const std::string& name) {
  const netcdf::Variable* found = file.find(name);
  if (found == nullptr) refuse_file(file, "no variable '" + name + "'");
  return *found;
}

UtcTime time_of(const netcdf::File& file, double seconds) {
  if (!(std::abs(seconds) < 1e12)) refuse_file(file, "a time that is none");
  return UtcTime(Duration(std::llround(seconds * 1000.0)));
}

std::vector<TimeCell> read_times(const netcdf::File& file) {
  std::vector<TimeCell> cells;
  if (file.find("time") == nullptr) return cells;
  const std::vector<double> centres = file.read_all(need(file, "time"));
  if (const netcdf::Variable* bounds = file.find("time_bnds")) {
    const std::vector<double> edges = file.read_all(*bounds);
    if (edges.size() != 2 * centres.size()) refuse_file(file, "time_bnds does not fit time");
    for (std::size_t t = 0; t < centres.size(); ++t) {
      cells.push_back({time_of(file, edges[2 * t]), time_of(file, edges[2 * t + 1])});
    }
  } else {
    for (const double centre : centres) cells.push_back(TimeCell::instant(time_of(file, centre)));
  }
  return cells;
}

Grid read_grid(const netcdf::File& file) {
  Grid grid;
  grid.time = read_times(file);
  for (const VerticalKind kind : {VerticalKind::depth_m, VerticalKind::height_m}) {
    if (const netcdf::Variable* level = file.find(level_name(kind))) {
      grid.vertical = kind;
      grid.levels_m = file.read_all(*level);
    }
  }
  grid.latitude_deg = file.read_all(need(file, "latitude"));
  grid.longitude_deg = file.read_all(need(file, "longitude"));
  try {
    expect_canonical(grid);
  } catch (const ContractViolation& violation) {
    refuse_file(file, violation.what());
  }
  return grid;
}

std::optional<double> number_of(const netcdf::File& file, std::string_view name) {
  for (const netcdf::Attribute& attribute : file.attributes()) {
    if (attribute.name == name) return attribute.number();
  }
  return std::nullopt;
}

std::optional<bool> tide_of(const netcdf::Variable& variable) {
  const auto text = variable.text("contains_tide");
  if (!text) return std::nullopt;
  return *text == "true";
}

Granule read_granule(const netcdf::File& file) {
  Granule granule;
  granule.grid = read_grid(file);
  const std::vector<std::size_t> shape =
      GranuleLayout::of(granule.grid)
          .present({granule.grid.times(), granule.grid.levels(), granule.grid.rows(),
                    granule.grid.columns()});
  for (const netcdf::Variable& variable : file.variables()) {
    const auto source_name = variable.text("source_name");
    if (!source_name) continue;
    if (variable.shape != shape)
      refuse_file(file, "variable '" + variable.name + "' does not fit the axes");
    granule.variables.push_back({variable.name, variable.text("units").value_or(""), *source_name,
                                 variable.text("contains_stokes") == "true",
                                 variable.find("ancillary_variables") != nullptr,
                                 tide_of(variable)});
  }
  if (granule.variables.empty()) refuse_file(file, "no values");
  granule.product_id = file.text("product").value_or("");
  granule.dataset_id = file.text("dataset").value_or("");
  granule.is_regional = file.text("region") == "regional";
  if (const auto after_h = number_of(file, "published_after_h"))
    granule.published_after = add_hours(UtcTime{}, std::clamp(*after_h, 0.0, 1e4)) - UtcTime{};
  granule.attribution = file.text("attribution").value_or("");
  granule.station = file.text("station").value_or("");
  granule.is_point_series = file.text("featureType_of_source").has_value();
  granule.water_depth_m = number_of(file, "water_depth_m");
  granule.stated_error_m_s = number_of(file, "stated_error_m_s");
  if (const auto member = number_of(file, "ensemble_member")) {
    granule.ensemble_member = static_cast<int>(std::clamp(*member, -1e6, 1e6));
  }
  const auto status = data_status_from(file.text("status").value_or(""));
  if (!status) refuse_file(file, "no status");
  granule.status = *status;
  if (const auto reference = file.text("reference_time"))
    granule.reference_time = parse_utc(*reference);
  return granule;
}

}  // namespace

struct GranuleFile::State {
  netcdf::File file;
  Granule granule;
};

GranuleFile::GranuleFile(std::unique_ptr<State> state) : state_(std::move(state)) {}
GranuleFile::~GranuleFile() = default;
GranuleFile::GranuleFile(GranuleFile&&) noexcept = default;

GranuleFile GranuleFile::open(const std::filesystem::path& file) {
  netcdf::File content = netcdf::File::open(file);
  Granule granule = read_granule(content);
  return GranuleFile(std::make_unique<State>(State{std::move(content), std::move(granule)}));
}

const Granule& GranuleFile::granule() const noexcept { return state_->granule; }

GriddedField GranuleFile::read(std::string_view standard_name, std::size_t first_time,
                               std::size_t times, std::size_t first_row, std::size_t rows,
                               std::size_t first_column, std::size_t columns) const {
  const Grid& whole = state_->granule.grid;
  expects(first_time + times <= whole.times() && first_row + rows <= whole.rows() &&
              first_column + columns <= whole.columns() && times > 0 && rows > 0 && columns > 0,
          "read: a block inside the granule");
  const auto& variables = state_->granule.variables;
  const auto found =
      std::find_if(variables.begin(), variables.end(),
                   [&](const GranuleVariable& v) { return v.standard_name == standard_name; });
  if (found == variables.end()) {
    throw Error(ErrorKind::not_found,
                state_->file.path().string() + ": holds no " + std::string(standard_name));
  }
  GriddedField field;
  field.standard_name = found->standard_name;
  field.unit = found->unit;
  field.grid.vertical = whole.vertical;
  field.grid.levels_m = whole.levels_m;
  const auto part = [](const auto& axis, std::size_t first, std::size_t count) {
    using Axis = std::remove_cvref_t<decltype(axis)>;
    const auto begin = axis.begin() + static_cast<std::ptrdiff_t>(first);
    return Axis(begin, begin + static_cast<std::ptrdiff_t>(count));
  };
  if (!whole.time.empty()) field.grid.time = part(whole.time, first_time, times);
  field.grid.latitude_deg = part(whole.latitude_deg, first_row, rows);
  field.grid.longitude_deg = part(whole.longitude_deg, first_column, columns);

  const GranuleLayout layout = GranuleLayout::of(whole);
  const auto start = layout.present({first_time, 0, first_row, first_column});
  const auto count = layout.present({times, whole.levels(), rows, columns});
  field.values.resize(times * whole.levels() * rows * columns);
  state_->file.read(need(state_->file, found->standard_name), start, count,
                    std::span<float>(field.values));
  if (found->has_status) {
    std::vector<float> flags(field.values.size());
    state_->file.read(need(state_->file, found->standard_name + "_status"), start, count,
                      std::span<float>(flags));
    field.status.reserve(flags.size());
    for (const float flag : flags) {
      if (!(flag <= static_cast<float>(SampleStatus::suspect)))
        refuse_file(state_->file, "an unknown status flag");
      field.status.push_back(static_cast<SampleStatus>(static_cast<int>(flag)));
    }
  }
  return field;
}

}  // namespace slackwater::ingest
