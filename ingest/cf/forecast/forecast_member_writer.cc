#include <algorithm>
#include <cmath>
#include <numeric>

#include "fields/base/check.h"
#include "ingest/cf/forecast/forecast_members.h"
#include "ingest/cf/forecast/forecast_names.h"

namespace slackwater::ingest {
namespace {

using netcdf::Type;
using netcdf::Writer;

/// Values of a chunk: 1 MiB of floats, so that one column of many is read without inflating all.
constexpr std::size_t member_chunk_values = std::size_t{256} << 10;
/// A fifth of the bytes go at level 1; higher levels save 2 % more and take twice the time.
constexpr int deflate_level = 1;

std::string rounding(double step_m_s) {
  return "rounded to multiples of 2^" + std::to_string(std::ilogb(step_m_s)) +
         " m s-1; member 0 is the variable without realization";
}

float rounded(double velocity_m_s, double step_m_s) noexcept {
  return static_cast<float>(std::round(velocity_m_s / step_m_s) * step_m_s);
}

}  // namespace

Horizontal as_filed(Horizontal member_m_s, double step_m_s) noexcept {
  return {static_cast<double>(rounded(member_m_s.real(), step_m_s)),
          static_cast<double>(rounded(member_m_s.imag(), step_m_s))};
}

Snapshot as_filed(Snapshot forecast) {
  for (ForecastColumn& column : forecast.columns) {
    for (Horizontal& u : column.member_m_s) u = as_filed(u, member_step_m_s);
    for (Horizontal& u : column.wind_member_m_s) u = as_filed(u, wind_member_step_m_s);
  }
  return forecast;
}

bool MemberWriter::has(const MemberVariable& variable) const {
  return variable.levels(s_) > 0 &&
         std::any_of(s_.columns.begin(), s_.columns.end(),
                     [&](const ForecastColumn& c) { return !(c.*variable.values).empty(); });
}

std::size_t MemberWriter::columns_per_chunk(const MemberVariable& variable) const {
  const std::size_t per_column = s_.time.size() * variable.levels(s_) * (s_.members - 1);
  return std::clamp<std::size_t>(member_chunk_values / per_column, 1, s_.columns.size());
}

void MemberWriter::define(int time, int depth, std::optional<int> column) {
  if (s_.members < 2) return;
  many_ = column.has_value();
  const int realization = out_.dimension("realization", s_.members - 1);
  realization_id_ = out_.variable("realization", Type::int32, {realization});
  out_.attribute(realization_id_, "standard_name", "realization");
  out_.attribute(realization_id_, "long_name", "ensemble member; 0, the central one, stands apart");
  out_.attribute(realization_id_, "units", "1");
  for (const MemberVariable& variable : member_variables) {
    if (!has(variable)) continue;
    std::vector<int> dimensions{time};
    if (variable.on_depth) dimensions.push_back(depth);
    if (column) dimensions.push_back(*column);
    dimensions.push_back(realization);
    define(variable, dimensions);
  }
  define_numbers(realization, column);
}

void MemberWriter::define_numbers(int realization, std::optional<int> column) {
  if (std::all_of(s_.columns.begin(), s_.columns.end(),
                  [](const ForecastColumn& c) { return c.wind_member_number.empty(); }))
    return;
  std::vector<int> dimensions;
  if (column) dimensions.push_back(*column);
  dimensions.push_back(realization);
  Writer::Layout layout;
  layout.fill_value = no_wind_member;
  number_id_ = out_.variable(forecast_names::wind_member, Type::int32, dimensions, layout);
  out_.attribute(number_id_, "long_name",
                 "number of the weather ensemble's member whose wind drives this member");
  out_.attribute(number_id_, "units", "1");
  out_.attribute(number_id_, "comment", "ensemble: " + s_.wind_ensemble);
}

void MemberWriter::define(const MemberVariable& variable, const std::vector<int>& dimensions) {
  const std::size_t levels = variable.levels(s_);
  const std::size_t columns = columns_per_chunk(variable);
  const std::size_t members = s_.members - 1;
  const std::size_t times_per_chunk = std::clamp<std::size_t>(
      member_chunk_values / (levels * columns * members), 1, s_.time.size());
  Writer::Layout layout;
  layout.chunks = {times_per_chunk};
  if (variable.on_depth) layout.chunks.push_back(levels);
  if (many_) layout.chunks.push_back(columns);
  layout.chunks.push_back(members);
  layout.deflate = deflate_level;
  layout.fill_value = forecast_names::member_fill;
  const int id = out_.variable(variable.name(), Type::float32, dimensions, layout);
  out_.attribute(id, "standard_name", variable.standard_name);
  out_.attribute(id, "long_name", variable.long_name);
  out_.attribute(id, "units", "m s-1");
  out_.attribute(id, "comment", rounding(variable.step_m_s));
  // Latitude and longitude go without saying (station_name leads to them): named here, cdo takes
  // them for the last axes, does not find them there and drops the variable.
  out_.attribute(id, "coordinates",
                 variable.on_depth ? "time depth station_name" : "time station_name");
  variables_.emplace_back(variable, id);
}

void MemberWriter::write() {
  if (realization_id_ < 0) return;
  std::vector<double> numbers(s_.members - 1);
  std::iota(numbers.begin(), numbers.end(), 1.0);
  out_.write_all(realization_id_, numbers);
  for (const auto& [variable, id] : variables_) write(variable, id);
  if (number_id_ >= 0) write_numbers();
}

void MemberWriter::write_numbers() {
  std::vector<double> numbers;
  for (const ForecastColumn& column : s_.columns) {
    for (std::size_t m = 0; m + 1 < s_.members; ++m)
      numbers.push_back(column.wind_member_number.empty() ? no_wind_member
                                                          : column.wind_member_number[m]);
  }
  out_.write_all(number_id_, numbers);
}

void MemberWriter::write(const MemberVariable& variable, int id) {
  const std::size_t step = columns_per_chunk(variable);
  for (std::size_t first = 0; first < s_.columns.size(); first += step) {
    const std::size_t columns = std::min(step, s_.columns.size() - first);
    std::vector<std::size_t> start{0};
    std::vector<std::size_t> count{s_.time.size()};
    const auto along = [&](std::size_t from, std::size_t length) {
      start.push_back(from);
      count.push_back(length);
    };
    if (variable.on_depth) along(0, variable.levels(s_));
    if (many_) along(first, columns);
    along(0, s_.members - 1);
    out_.write(id, start, count, block(variable, first, columns));
  }
}

std::vector<float> MemberWriter::block(const MemberVariable& variable, std::size_t first,
                                       std::size_t columns) const {
  const std::size_t cells = s_.time.size() * variable.levels(s_);
  const std::size_t members = s_.members - 1;
  std::vector<float> values(cells * columns * members, forecast_names::member_fill);
  for (std::size_t c = 0; c < columns; ++c) {
    const ForecastColumn& column = s_.columns[first + c];
    const std::vector<Horizontal>& all = column.*variable.values;
    if (all.empty()) continue;
    for (std::size_t m = 0; m < members; ++m) {
      for (std::size_t cell = 0; cell < cells; ++cell) {
        if (!variable.is_there(column, cell)) continue;
        const Horizontal member = all[m * cells + cell];
        const double value = variable.north ? member.imag() : member.real();
        // Up to 2^23 steps, 1024 m/s for the current, a float holds each multiple exactly.
        expects(std::abs(value) <= 1000, "a member has a velocity wherever the forecast has one");
        values[(cell * columns + c) * members + m] = rounded(value, variable.step_m_s);
      }
    }
  }
  return values;
}

}  // namespace slackwater::ingest
