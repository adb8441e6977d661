#include <algorithm>
#include <cmath>

#include "fields/base/error.h"
#include "ingest/cf/forecast/forecast_members.h"
#include "ingest/cf/forecast/forecast_names.h"

namespace slackwater::ingest {
namespace {

// A forecast has tens of members at hundreds of columns. These bounds keep a hostile file, which
// deflates to nothing, from eating memory (1 GiB of members at most) and time (a large chunk is
// inflated again for each block of columns).
constexpr std::size_t max_members = 1024;
constexpr std::size_t max_values = std::size_t{64} << 20;
constexpr std::size_t max_chunk_values = std::size_t{1} << 20;
constexpr std::size_t values_per_read = std::size_t{1} << 20;

constexpr double most_wind_members = 1e6;

/// Shape that a member variable must have, so that every index below is inside it.
std::vector<std::size_t> shape_of(const MemberVariable& variable, const Snapshot& s,
                                  std::size_t file_columns, bool many) {
  std::vector<std::size_t> shape{s.time.size()};
  if (variable.on_depth) shape.push_back(s.depth_m.size());
  if (many) shape.push_back(file_columns);
  shape.push_back(s.members - 1);
  return shape;
}

void expect_sane(const netcdf::File& file, const netcdf::Variable& found,
                 const std::vector<std::size_t>& shape) {
  if (found.shape != shape) refuse_forecast(file, found.name + " has an unexpected shape");
  if (found.size() > max_values) {
    refuse_forecast(file, found.name + " holds " + std::to_string(found.size()) +
                              " values; at most " + std::to_string(max_values) + " are read");
  }
  std::size_t chunk = 1;
  for (const std::size_t length : found.chunks) {
    if (__builtin_mul_overflow(chunk, length, &chunk) || chunk > max_chunk_values)
      refuse_forecast(file, found.name + " is kept in chunks that are too large");
  }
}

/// Puts one component of a block of columns in its place.
/// @param values  over (cell, column, member)
void place(const netcdf::File& file, const MemberVariable& variable, Snapshot& s, std::size_t first,
           std::size_t columns, const std::vector<float>& values) {
  const std::size_t cells = s.time.size() * variable.levels(s);
  const std::size_t members = s.members - 1;
  for (std::size_t c = 0; c < columns; ++c) {
    ForecastColumn& column = s.columns[first + c];
    std::vector<Horizontal>& all = column.*variable.values;
    const auto at = [&](std::size_t cell, std::size_t m) {
      return values[(cell * columns + c) * members + m];
    };
    std::size_t there = 0;
    std::size_t found = 0;
    for (std::size_t cell = 0; cell < cells; ++cell) {
      if (!variable.is_there(column, cell)) continue;
      there += members;
      for (std::size_t m = 0; m < members; ++m)
        found += at(cell, m) != forecast_names::member_fill ? 1U : 0U;
    }
    if (found == 0 && all.empty()) continue;  // a column without members
    if (!variable.on_depth && column.wind_m_s.empty())
      refuse_forecast(file, "found members of a wind without its central one");
    // East comes first and makes the room: north alone must not read as an east of zero.
    if (found != there || (variable.north && all.empty()))
      refuse_forecast(file, "found a member that is not whole");
    all.resize(cells * members);
    for (std::size_t m = 0; m < members; ++m) {
      for (std::size_t cell = 0; cell < cells; ++cell) {
        if (!variable.is_there(column, cell)) continue;
        const double value = static_cast<double>(at(cell, m));
        if (!std::isfinite(value)) refuse_forecast(file, "found a member that is not a number");
        Horizontal& member = all[m * cells + cell];
        member = variable.north ? Horizontal(member.real(), value) : Horizontal(value, 0);
      }
    }
  }
}

/// Whose wind each member has, where a weather ensemble drives them.
void read_numbers(const netcdf::File& file, Snapshot& s, std::size_t first, std::size_t count,
                  bool many) {
  const netcdf::Variable* found = file.find(forecast_names::wind_member);
  if (found == nullptr) return;
  const std::size_t members = s.members - 1;
  std::vector<std::size_t> shape{members};
  if (many) shape.insert(shape.begin(), s.columns.size());
  expect_sane(file, *found, shape);
  const std::vector<double> numbers = file.read_all(*found);
  for (std::size_t c = first; c < first + count; ++c) {
    std::vector<int> own;
    for (std::size_t m = 0; m < members; ++m) {
      const double number = numbers[c * members + m];
      if (number == no_wind_member) continue;
      if (!(number >= 0 && number <= most_wind_members && number == std::floor(number)))
        refuse_forecast(file, "found a wind member without a number");
      own.push_back(static_cast<int>(number));
    }
    if (own.empty()) continue;
    if (own.size() != members || s.columns[c].wind_member_m_s.empty())
      refuse_forecast(file, "found wind members for some members only");
    s.columns[c].wind_member_number = std::move(own);
  }
}

}  // namespace

void refuse_forecast(const netcdf::File& file, const std::string& what) {
  throw Error(ErrorKind::invalid_input,
              file.path().string() + ": " + what +
                  "; expected a forecast written by Slackwater; run `slackwater store check`");
}

std::size_t count_members(const netcdf::File& file) {
  const netcdf::Variable* realization = file.find("realization");
  if (realization == nullptr) return 1;
  if (realization->shape.size() != 1 || realization->shape[0] < 1 ||
      realization->shape[0] >= max_members) {
    refuse_forecast(file, "found a realization that is no list of at most " +
                              std::to_string(max_members - 1) + " members");
  }
  const std::vector<double> numbers = file.read_all(*realization);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] != static_cast<double>(i + 1))
      refuse_forecast(file, "found members that are not numbered 1, 2, …");
  }
  return numbers.size() + 1;
}

void read_members(const netcdf::File& file, Snapshot& snapshot, std::size_t first,
                  std::size_t count) {
  if (snapshot.members < 2) return;
  for (std::size_t i = 0; i < member_variables.size(); i += 2) {
    if ((file.find(member_variables[i].name()) == nullptr) !=
        (file.find(member_variables[i + 1].name()) == nullptr))
      refuse_forecast(file, "found members of one component only");
  }
  const netcdf::Variable* latitude = file.find("latitude");
  const bool many = latitude != nullptr && !latitude->shape.empty();
  for (const MemberVariable& variable : member_variables) {
    const netcdf::Variable* found = file.find(variable.name());
    if (found == nullptr) continue;
    if (variable.levels(snapshot) == 0)
      refuse_forecast(file, "found members of a current without depths");
    const std::vector<std::size_t> shape =
        shape_of(variable, snapshot, snapshot.columns.size(), many);
    expect_sane(file, *found, shape);
    const std::size_t per_column = found->size() / (many ? snapshot.columns.size() : 1);
    const std::size_t step = std::max<std::size_t>(1, values_per_read / per_column);
    for (std::size_t c = first; c < first + count; c += step) {
      const std::size_t columns = std::min(step, first + count - c);
      std::vector<std::size_t> start(shape.size(), 0);
      std::vector<std::size_t> size = shape;
      if (many) {
        start[shape.size() - 2] = c;
        size[shape.size() - 2] = columns;
      }
      std::vector<float> values(per_column * columns);
      file.read(*found, start, size, values);
      place(file, variable, snapshot, c, columns, values);
    }
  }
  read_numbers(file, snapshot, first, count, many);
}

}  // namespace slackwater::ingest
