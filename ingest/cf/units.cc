#include "ingest/cf/units.h"

#include <udunits2.h>

#include <array>
#include <cmath>
#include <memory>
#include <mutex>

#include "fields/base/error.h"

namespace slackwater::ingest {
namespace {

struct Spelling {
  std::string_view found;
  std::string_view meaning;  ///< a spelling that UDUNITS knows; our canonical units among them
};

/// Spellings that UDUNITS lacks, and frequent ones that need not wake it (it reads an XML data
/// base).
constexpr std::array spellings{
    Spelling{"m/s", "m s-1"},
    Spelling{"m.s-1", "m s-1"},
    Spelling{"m s**-1", "m s-1"},
    Spelling{"m s^-1", "m s-1"},
    Spelling{"m*s-1", "m s-1"},
    Spelling{"meter second-1", "m s-1"},
    Spelling{"meters/second", "m s-1"},
    Spelling{"meter/sec", "m s-1"},
    Spelling{"metre second-1", "m s-1"},
    Spelling{"m/sec", "m s-1"},
    Spelling{"ms-1", "m s-1"},
    Spelling{"meters", "m"},
    Spelling{"meter", "m"},
    Spelling{"metres", "m"},
    Spelling{"metre", "m"},
    Spelling{"seconds", "s"},
    Spelling{"second", "s"},
    Spelling{"sec", "s"},
    Spelling{"Degree true", "degree"},
    Spelling{"degree true", "degree"},
    Spelling{"degrees true", "degree"},
    Spelling{"Degrees true", "degree"},
    Spelling{"degree_true", "degree"},
    Spelling{"degrees_true", "degree"},
    Spelling{"degrees", "degree"},
    Spelling{"deg", "degree"},
    Spelling{"Degree", "degree"},
    Spelling{"Degrees", "degree"},
    Spelling{"degrees_C", "degC"},
    Spelling{"degree_C", "degC"},
    Spelling{"degree_Celsius", "degC"},
    Spelling{"degrees_Celsius", "degC"},
    Spelling{"Celsius", "degC"},
    Spelling{"celsius", "degC"},
    Spelling{"deg C", "degC"},
    Spelling{"deg_C", "degC"},
    Spelling{"°C", "degC"},
    Spelling{"C", "degC"},
    Spelling{"kelvin", "K"},
    Spelling{"Kelvin", "K"},
    Spelling{"dimensionless", "1"},
    Spelling{"(0 - 1)", "1"},
    Spelling{"-", "1"},
};

std::string_view meaning_of(std::string_view unit) {
  while (!unit.empty() && unit.front() == ' ') unit.remove_prefix(1);
  while (!unit.empty() && unit.back() == ' ') unit.remove_suffix(1);
  for (const Spelling& spelling : spellings) {
    if (spelling.found == unit) return spelling.meaning;
  }
  return unit;
}

struct FreeUnit {
  void operator()(ut_unit* unit) const noexcept { ut_free(unit); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;
struct FreeConverter {
  void operator()(cv_converter* converter) const noexcept { cv_free(converter); }
};

ut_system* unit_system() {
  // Read once and kept until the program ends.
  static ut_system* const system = [] {
    ut_set_error_message_handler(ut_ignore);
    return ut_read_xml(nullptr);
  }();
  if (system == nullptr) {
    throw Error(ErrorKind::unavailable,
                "the UDUNITS unit data base cannot be read; install libudunits2-data");
  }
  return system;
}

[[noreturn]] void refuse_units(std::string_view found, std::string_view canonical,
                               std::string_view what, std::string_view why) {
  throw Error(ErrorKind::invalid_input,
              std::string(what) + ": found unit '" + std::string(found) + "' (" + std::string(why) +
                  "); expected a unit that converts to '" + std::string(canonical) +
                  "'; correct the units attribute");
}

}  // namespace

UnitConversion unit_conversion(std::string_view found, std::string_view canonical,
                               std::string_view what) {
  const std::string meaning(meaning_of(found));
  const std::string target(meaning_of(canonical));
  if (meaning == target) return {};
  if (meaning == "degC" && target == "K") return {1.0, 273.15};
  if (found.size() > 128) refuse_units(found.substr(0, 40), canonical, what, "too long for a unit");
  static std::mutex mutex;  // UDUNITS is not thread-safe
  const std::lock_guard<std::mutex> lock(mutex);
  ut_system* system = unit_system();
  const Unit from(ut_parse(system, meaning.c_str(), UT_UTF8));
  const Unit to(ut_parse(system, target.c_str(), UT_UTF8));
  if (from == nullptr) refuse_units(found, canonical, what, "UDUNITS does not know this unit");
  if (to == nullptr) refuse_units(found, canonical, what, "the canonical unit is unknown");
  const Unit one(ut_get_dimensionless_unit_one(system));
  const bool number_for_angle =
      ut_compare(from.get(), one.get()) == 0 && ut_compare(to.get(), one.get()) != 0;
  if (number_for_angle || ut_are_convertible(from.get(), to.get()) == 0) {
    refuse_units(found, canonical, what, "another dimension");
  }
  const std::unique_ptr<cv_converter, FreeConverter> converter(
      ut_get_converter(from.get(), to.get()));
  if (converter == nullptr) refuse_units(found, canonical, what, "no conversion");
  UnitConversion conversion;
  conversion.offset = cv_convert_double(converter.get(), 0.0);
  conversion.scale = cv_convert_double(converter.get(), 1.0) - conversion.offset;
  // A logarithmic unit (dB) is not linear, and none of our quantities comes in one.
  const double at_ten = cv_convert_double(converter.get(), 10.0);
  if (!(std::abs(at_ten - (10.0 * conversion.scale + conversion.offset)) <=
        1e-6 * (1.0 + std::abs(at_ten)))) {
    refuse_units(found, canonical, what, "not a linear unit");
  }
  return conversion;
}

}  // namespace slackwater::ingest
