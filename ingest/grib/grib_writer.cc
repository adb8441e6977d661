#include "ingest/grib/grib_writer.h"

#include <fstream>

#include "fields/base/check.h"
#include "fields/base/error.h"
#include "fields/base/turn.h"
#include "fields/geo/geo_point.h"
#include "ingest/grib/message.h"
#include "ingest/grib/parameter.h"

namespace slackwater::ingest {
namespace {

constexpr long bits_per_value = 24;

double longitude_0_360(double longitude_deg) {
  return compass_deg(normalised_longitude_deg(longitude_deg));
}

void set_times(grib::Message& message, const GribField& field) {
  const UtcDay day = day_of(field.reference_time);
  const std::chrono::year_month_day date(day);
  const auto minutes =
      std::chrono::duration_cast<std::chrono::minutes>(field.reference_time - UtcTime(day));
  if (field.reference_time != UtcTime(day) + minutes) {
    throw Error(ErrorKind::invalid_input, "reference time " + format_utc(field.reference_time) +
                                              " has seconds; expected whole minutes");
  }
  message.set("dataDate", static_cast<long>(static_cast<int>(date.year())) * 10000 +
                              static_cast<long>(static_cast<unsigned>(date.month())) * 100 +
                              static_cast<long>(static_cast<unsigned>(date.day())));
  message.set("dataTime", minutes.count() / 60 * 100 + minutes.count() % 60);
  message.set("stepUnits", 1L);
  message.set("stepRange", std::to_string(field.step_hours));
}

void set_grid(grib::Message& message, const GribField& field) {
  const std::size_t rows = field.latitude_deg.size();
  const std::size_t columns = field.longitude_deg.size();
  message.set("Ni", static_cast<long>(columns));
  message.set("Nj", static_cast<long>(rows));
  message.set("iScansNegatively", 0L);
  message.set("jScansPositively", 0L);
  message.set("jPointsAreConsecutive", 0L);
  message.set("latitudeOfFirstGridPointInDegrees", field.latitude_deg.back());
  message.set("latitudeOfLastGridPointInDegrees", field.latitude_deg.front());
  message.set("longitudeOfFirstGridPointInDegrees", longitude_0_360(field.longitude_deg.front()));
  message.set("longitudeOfLastGridPointInDegrees", longitude_0_360(field.longitude_deg.back()));
  const auto step = [](const std::vector<double>& axis) {
    return axis.size() < 2 ? 1.0
                           : (axis.back() - axis.front()) / static_cast<double>(axis.size() - 1);
  };
  message.set("iDirectionIncrementInDegrees", step(field.longitude_deg));
  message.set("jDirectionIncrementInDegrees", step(field.latitude_deg));
}

void set_member(grib::Message& message, const GribField& field, int edition) {
  if (!field.member) return;
  const bool control = *field.member == 0;
  if (edition == 2) {
    message.set("productDefinitionTemplateNumber",
                1L);  // code table 4.0: individual ensemble forecast
    message.set("typeOfEnsembleForecast",
                control ? 1L : 3L);  // code table 4.6: control, positively perturbed
  } else {
    message.set("setLocalDefinition", 1L);
    message.set("localDefinitionNumber", 1L);  // ECMWF: MARS labelling or ensemble forecast
    message.set("type", control ? 10L : 11L);  // MARS: cf, pf
  }
  message.set("numberOfForecastsInEnsemble", 51L);
  message.set("perturbationNumber", static_cast<long>(*field.member));
}

std::vector<std::byte> coded(const GribField& field, int edition, bool ccsds) {
  const std::size_t rows = field.latitude_deg.size();
  const std::size_t columns = field.longitude_deg.size();
  expects(rows > 0 && columns > 0 && field.values.size() == rows * columns,
          "a GRIB field has one value for each latitude and longitude");
  if (grib::parameter_of(field.short_name) == nullptr) {
    throw Error(ErrorKind::invalid_input, "no GRIB parameter '" + field.short_name +
                                              "'; expected one of " + grib::known_parameters());
  }
  auto message = grib::Message::from_sample("regular_ll_sfc_grib" + std::to_string(edition));
  set_member(message, field, edition);
  message.set("shortName", field.short_name);
  set_times(message, field);
  set_grid(message, field);

  std::vector<double> north_to_south;
  north_to_south.reserve(field.values.size());
  for (std::size_t row = rows; row-- > 0;) {
    const auto first = field.values.begin() + static_cast<std::ptrdiff_t>(row * columns);
    north_to_south.insert(north_to_south.end(), first,
                          first + static_cast<std::ptrdiff_t>(columns));
  }
  if (ccsds) message.set("packingType", std::string("grid_ccsds"));
  message.set("bitsPerValue", bits_per_value);
  message.set_values(north_to_south);
  return message.bytes();
}

}  // namespace

void write_grib(const std::filesystem::path& file, std::span<const GribField> fields, int edition,
                bool ccsds) {
  if (edition != 1 && edition != 2) {
    throw Error(ErrorKind::invalid_input,
                "GRIB edition " + std::to_string(edition) + "; expected 1 or 2");
  }
  if (ccsds && edition == 1) {
    throw Error(ErrorKind::invalid_input,
                "GRIB 1 has no CCSDS packing; expected edition 2 with it");
  }
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  for (const GribField& field : fields) {
    const std::vector<std::byte> bytes = coded(field, edition, ccsds);
    stream.write(reinterpret_cast<const char*>(bytes.data()),
                 static_cast<std::streamsize>(bytes.size()));
  }
  stream.close();
  if (!stream) {
    throw Error(ErrorKind::unavailable,
                "cannot write " + file.string() +
                    "; check the folder, its permissions and the space on the disk");
  }
}

}  // namespace slackwater::ingest
