#include "tests/api/door/edr/made_up_answer.h"

#include <limits>
#include <string>

#include "api/door/edr/sample/answer_shape.h"

namespace slackwater::tests {
namespace {

using api::edr::Answer;
using api::edr::Coverage;
using api::edr::DomainType;
using api::edr::Parameter;

Parameter current(const std::string& direction, const std::string& suffix,
                  const std::string& method) {
  return {direction + "_sea_water_velocity" + suffix,
          direction + "_sea_water_velocity",
          direction + " current",
          "Eulerian, towards",
          "m/s",
          "metre per second",
          method};
}

std::vector<UtcTime> hours(std::size_t count) {
  const UtcTime start = parse_utc("2025-03-10T00:00:00Z");
  std::vector<UtcTime> times;
  for (std::size_t i = 0; i < count; ++i) times.push_back(start + std::chrono::hours(i));
  return times;
}

std::vector<double> steps(double start, double step, std::size_t count) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(start + step * static_cast<double>(i));
  return values;
}

Coverage domain(DomainType type, std::size_t number, std::size_t levels) {
  Coverage c;
  c.domain = type;
  c.id = "place-" + std::to_string(number);
  const double west = 2.45 + static_cast<double>(number);
  c.longitude_deg = {west};
  c.latitude_deg = {57.25};
  c.vertical_m = {10};
  c.time = hours(1);
  switch (type) {
    case DomainType::point:
      break;
    case DomainType::point_series:
      c.time = hours(25);
      break;
    case DomainType::vertical_profile:
      c.vertical_m = steps(0.5, 10, levels);
      break;
    case DomainType::grid:
      c.time = hours(2);
      c.vertical_m = steps(0.5, 10, levels);
      c.latitude_deg = steps(57.25, 0.0625, 2);
      c.longitude_deg = steps(west, 0.1, 3);
      break;
    case DomainType::trajectory:
      c.time = hours(5);
      c.vertical_m = steps(0, 5, 5);
      c.latitude_deg = steps(57.25, 0.01, 5);
      c.longitude_deg = steps(west, 0.0123456789, 5);
      break;
  }
  return c;
}

}  // namespace

Answer made_up_answer(DomainType type, std::size_t coverages, std::size_t levels) {
  Answer answer;
  answer.collection = "currents";
  answer.title = "Currents at \"Utsira Nord\"";
  answer.vertical = api::edr::Vertical::depth_down;
  answer.parameters = {current("eastward", "", "central"), current("northward", "", "central"),
                       current("eastward", "_p10", "quantile 0.1")};
  for (std::size_t number = 0; number < coverages; ++number) {
    Coverage c = domain(type, number, levels);
    for (std::size_t p = 0; p < answer.parameters.size(); ++p) {
      std::vector<double> values;
      for (std::size_t i = 0; i < shape_of(c).size(); ++i) {
        values.push_back(made_up_value(number, p, i));
      }
      c.values.push_back(std::move(values));
    }
    c.values[1][0] = std::numeric_limits<double>::quiet_NaN();
    answer.coverages.push_back(std::move(c));
  }
  answer.provenance = {
      "utsira-nord",
      "20250309T0500Z",
      parse_utc("2025-03-10T05:00:00Z"),
      parse_day("2025-03-09"),
      "wind persisted",
      true,
      {"© E.U. Copernicus Marine Service Information", "MET Norway, \"CC BY\" 4.0"},
      "0.4.0+abc"};
  answer.notes = {"below the bed at 10 m"};
  answer.query_url = "http://localhost:8080/collections/currents/position?coords=POINT(2.45 57.25)";
  answer.links = {{"self", "application/geo+json", answer.query_url}};
  return answer;
}

}  // namespace slackwater::tests
