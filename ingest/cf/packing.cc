#include "ingest/cf/packing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::ingest {
namespace {

using netcdf::Type;

bool is_integer(Type type) {
  return type != Type::float32 && type != Type::float64 && type != Type::character &&
         type != Type::string && type != Type::other;
}

/// Fill values of the NetCDF library where a file names none (netcdf.h, NC_FILL_*). Bytes have
/// none.
double default_fill(Type type) {
  switch (type) {
    case Type::int16:
      return -32767.0;
    case Type::uint16:
      return 65535.0;
    case Type::int32:
      return -2147483647.0;
    case Type::uint32:
      return 4294967295.0;
    case Type::int64:
      return -9223372036854775806.0;
    case Type::uint64:
      return 18446744073709551614.0;
    case Type::float32:
      return static_cast<double>(9.9692099683868690e+36F);
    case Type::float64:
      return 9.9692099683868690e+36;
    default:
      return constants::nan;
  }
}

double unsigned_turn(const netcdf::Variable& variable) {
  const auto text = variable.text("_Unsigned");
  if (!text || (*text != "true" && *text != "True" && *text != "TRUE")) return 0.0;
  switch (variable.type) {
    case Type::int8:
      return 256.0;
    case Type::int16:
      return 65536.0;
    case Type::int32:
      return 4294967296.0;
    default:
      return 0.0;
  }
}

// A depth of nothing is land.
constexpr auto smallest_depth = static_cast<double>(std::numeric_limits<float>::min());

template <typename T>
void keep_unless_equal(T* values, std::size_t n, T missing) noexcept {
  if (std::isnan(missing)) return;
  for (std::size_t i = 0; i < n; ++i)
    values[i] = values[i] == missing ? std::numeric_limits<T>::quiet_NaN() : values[i];
}

template <typename T>
void keep_inside(T* values, std::size_t n, T low, T high) noexcept {
  for (std::size_t i = 0; i < n; ++i)
    values[i] = values[i] >= low ? values[i] : std::numeric_limits<T>::quiet_NaN();
  for (std::size_t i = 0; i < n; ++i)
    values[i] = values[i] <= high ? values[i] : std::numeric_limits<T>::quiet_NaN();
}

template <typename T>
std::size_t count_missing(const T* values, std::size_t n) noexcept {
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < n; ++i) count += values[i] != values[i] ? 1U : 0U;
  return count;
}

/// The limits as written, and whether their type says that they are unpacked.
struct WrittenLimits {
  std::optional<double> low, high;
  bool are_unpacked = false;
};

WrittenLimits limits_of(const netcdf::Variable& variable) {
  WrittenLimits limits;
  const auto take = [&](const netcdf::Attribute& attribute, std::optional<double> low,
                        std::optional<double> high) {
    if (low) limits.low = low;
    if (high) limits.high = high;
    limits.are_unpacked = attribute.type != variable.type && !is_integer(attribute.type);
  };
  if (const netcdf::Attribute* attribute = variable.find("valid_range")) {
    const auto* values = std::get_if<std::vector<double>>(&attribute->value);
    if (values != nullptr && values->size() == 2) take(*attribute, (*values)[0], (*values)[1]);
  }
  if (const netcdf::Attribute* attribute = variable.find("valid_min"))
    take(*attribute, attribute->number(), std::nullopt);
  if (const netcdf::Attribute* attribute = variable.find("valid_max"))
    take(*attribute, std::nullopt, attribute->number());
  return limits;
}

}  // namespace

std::string lost_by_limits(const std::string& variable, const DecodeCounts& counts) {
  const std::size_t known = counts.values + counts.gross + counts.outside;
  return formatted(
      "'{}': {} of {} values ({:.1f} %) lie outside the valid range that the file states and are "
      "taken as missing; if they are sound, take valid_min, valid_max, valid_range out of the file",
      variable, counts.outside, known,
      100.0 * static_cast<double>(counts.outside) /
          static_cast<double>(std::max<std::size_t>(known, 1)));
}

void Packing::read_limits(const netcdf::Variable& variable, std::vector<std::string>& warnings) {
  const WrittenLimits written = limits_of(variable);
  if (!written.low && !written.high) return;
  const bool packed = scale_ != 1.0 || offset_ != 0.0;
  const double rounding = is_integer(variable.type) ? 0.5 : 0.0;  // of the packed numbers
  const auto read = [&](bool unpacked) {
    const auto raw = [&](double value) {
      if (unpacked) return (value - offset_) / scale_;
      return value < 0.0 ? value + unsigned_turn_ : value;
    };
    Limits limits;
    if (written.low) limits.low = raw(*written.low);
    if (written.high) limits.high = raw(*written.high);
    if (unpacked && scale_ < 0) {
      limits = {written.high ? limits.high : Limits{}.low,
                written.low ? limits.low : Limits{}.high};
    }
    if (unpacked) limits = {limits.low - rounding, limits.high + rounding};
    return limits;
  };
  const bool unpacked = packed && written.are_unpacked;
  limits_ = read(unpacked);
  if (!(limits_.low <= limits_.high)) {
    warnings.push_back("variable '" + variable.name +
                       "': its valid range is empty or not a number and is ignored");
    limits_ = {};
    return;
  }
  if (!packed) return;
  const Limits other = read(!unpacked);
  if (other.low <= other.high) other_ = other;
  other_is_packed_ = unpacked;
}

void Packing::settle_limits(std::span<const double> raw, const std::string& variable,
                            std::vector<std::string>& warnings) {
  if (!other_) return;
  std::size_t known = 0;
  std::size_t lost = 0;
  std::size_t lost_by_other = 0;
  for (double value : raw) {
    if (value < 0) value += unsigned_turn_;
    if (std::isnan(value) || std::find(missing_.begin(), missing_.end(), value) != missing_.end())
      continue;
    ++known;
    lost += value < limits_.low || value > limits_.high ? 1 : 0;
    lost_by_other += value < other_->low || value > other_->high ? 1 : 0;
  }
  // A range that a product keeps to drops next to nothing.
  if (2 * lost <= known || 10 * lost_by_other > known) return;
  warnings.push_back("'" + variable + "': read as " +
                     (other_is_packed_ ? "unpacked values" : "packed numbers") +
                     " its valid range would drop " + std::to_string(lost) + " of " +
                     std::to_string(known) + " values; it is read as " +
                     (other_is_packed_ ? "packed numbers" : "values in the unit of the variable"));
  limits_ = *other_;
  other_.reset();
}

Packing Packing::of(const netcdf::Variable& variable, std::vector<std::string>& warnings) {
  Packing packing;
  const auto scale = variable.number("scale_factor");
  const auto offset = variable.number("add_offset");
  packing.scale_ = scale.value_or(1.0);
  packing.offset_ = offset.value_or(0.0);
  if (!std::isfinite(packing.scale_) || packing.scale_ == 0.0 || !std::isfinite(packing.offset_)) {
    throw Error(ErrorKind::invalid_input,
                "variable '" + variable.name + "': scale_factor " + std::to_string(packing.scale_) +
                    ", add_offset " + std::to_string(packing.offset_) +
                    "; expected finite numbers and a scale that is not 0");
  }
  packing.unsigned_turn_ = unsigned_turn(variable);
  packing.wide_ = variable.type == Type::float64 || variable.type == Type::int32 ||
                  variable.type == Type::uint32 || variable.type == Type::int64 ||
                  variable.type == Type::uint64;
  const auto as_raw = [&](double value) {
    return value < 0.0 ? value + packing.unsigned_turn_ : value;
  };

  const auto fill = variable.number("_FillValue");
  packing.missing_[0] = as_raw(fill.value_or(default_fill(variable.type)));
  if (const netcdf::Attribute* missing = variable.find("missing_value")) {
    if (const auto* values = std::get_if<std::vector<double>>(&missing->value)) {
      for (std::size_t i = 0; i < std::min<std::size_t>(values->size(), 2); ++i)
        packing.missing_[i + 1] = as_raw((*values)[i]);
    }
  }

  packing.read_limits(variable, warnings);
  return packing;
}

void Packing::convert(const UnitConversion& unit) noexcept {
  scale_ *= unit.scale;
  offset_ = offset_ * unit.scale + unit.offset;
}

void Packing::negate() noexcept {
  scale_ = -scale_;
  offset_ = -offset_;
}

double Packing::coordinate(double raw) const noexcept {
  if (raw < 0) raw += unsigned_turn_;
  for (const double missing : missing_) {
    if (raw == missing) return constants::nan;
  }
  return raw * scale_ + offset_;
}

template <typename Raw>
void Packing::decode_as(std::span<const Raw> raw, std::span<float> out,
                        DecodeCounts& counts) const noexcept {
  const auto limited = [](double limit) {
    constexpr auto largest = static_cast<double>(std::numeric_limits<Raw>::max());
    return static_cast<Raw>(std::clamp(limit, -largest, largest));
  };
  // Limits and missing values in the type of the data: 1e20f must meet 1e20f, not 1e20.
  const Raw low = limited(limits_.low);
  const Raw high = limited(limits_.high);
  const auto mark = [&](double value) {
    return std::isnan(value) ? static_cast<Raw>(value) : limited(value);
  };
  const Raw m0 = mark(missing_[0]);
  const Raw m1 = mark(missing_[1]);
  const Raw m2 = mark(missing_[2]);
  const Raw turn = static_cast<Raw>(unsigned_turn_);
  const bool identity = scale_ == 1.0 && offset_ == 0.0;
  const double gross_low = only_positive_ ? std::max(gross_.low, smallest_depth) : gross_.low;
  const double gross_high = gross_.high;
  const bool has_limits = std::isfinite(limits_.low) || std::isfinite(limits_.high);
  std::size_t missing = 0;
  std::size_t outside = 0;
  std::size_t gross = 0;
  // One condition a pass over a stretch that stays in the nearest cache: each loop becomes vector
  // code.
  constexpr std::size_t stretch = 2048;
  Raw clean[stretch];
  for (std::size_t first = 0; first < raw.size(); first += stretch) {
    const std::size_t n = std::min(stretch, raw.size() - first);
    const Raw* in = raw.data() + first;
    float* to = out.data() + first;
    for (std::size_t i = 0; i < n; ++i) clean[i] = in[i] < Raw{0} ? in[i] + turn : in[i];
    keep_unless_equal(clean, n, m0);
    keep_unless_equal(clean, n, m1);
    keep_unless_equal(clean, n, m2);
    const std::size_t fill = has_limits ? count_missing(clean, n) : 0;
    keep_inside(clean, n, low, high);
    const std::size_t absent = count_missing(clean, n);
    if (has_limits) outside += absent - fill;
    missing += absent;
    if (absent == n) {
      std::fill_n(to, n, std::numeric_limits<float>::quiet_NaN());
      continue;
    }
    if (identity) {
      keep_inside(clean, n, limited(gross_low), limited(gross_high));
      for (std::size_t i = 0; i < n; ++i) to[i] = static_cast<float>(clean[i]);
    } else {
      const auto float_low = static_cast<float>(gross_low);
      const auto float_high = static_cast<float>(gross_high);
      for (std::size_t i = 0; i < n; ++i)
        to[i] = static_cast<float>(static_cast<double>(clean[i]) * scale_ + offset_);
      keep_inside(to, n, float_low, float_high);
    }
    gross += count_missing(to, n) - absent;
  }
  if (only_positive_) {
    // Land, not a gross error.
    missing += gross;
    gross = 0;
  }
  counts.values += raw.size() - missing - gross;
  counts.missing += missing;
  counts.outside += outside;
  counts.gross += gross;
}

void Packing::decode(std::span<const float> raw, std::span<float> out,
                     DecodeCounts& counts) const noexcept {
  decode_as<float>(raw, out, counts);
}

void Packing::decode(std::span<const double> raw, std::span<float> out,
                     DecodeCounts& counts) const noexcept {
  decode_as<double>(raw, out, counts);
}

}  // namespace slackwater::ingest
