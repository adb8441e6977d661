#include "ingest/cf/forecast/averaged_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "fields/base/error.h"

namespace slackwater::ingest {
namespace {

using nlohmann::json;
constexpr double ms_of_an_hour = 3.6e6;

[[noreturn]] void refuse(const std::string& why) {
  throw Error(ErrorKind::invalid_input, "averaged currents: " + why +
                                            "; expected a JSON object with mean_h, as the program "
                                            "writes it, or null");
}

AveragedCurrents averaged_of(const json& object) {
  AveragedCurrents averaged;
  const double mean_h = object.at("mean_h").get<double>();
  if (!(mean_h > 0 && mean_h < 1e5)) refuse("found a mean over " + object.at("mean_h").dump());
  averaged.averaging = Duration(static_cast<Duration::rep>(std::llround(mean_h * ms_of_an_hour)));
  averaged.holds_part_of_the_tide = object.at("holds_part_of_the_tide").get<bool>();
  if (const json& tide = object.at("unresolved_tide_m_s"); !tide.is_null())
    averaged.unresolved_tide_m_s = tide.get<double>();
  if (const json& record = object.at("tidal_record"); !record.is_null())
    averaged.tidal_record = record.get<std::string>();
  return averaged;
}

}  // namespace

std::string averaged_json(const std::optional<AveragedCurrents>& averaged) {
  if (!averaged) return "null";
  const json object = {
      {"mean_h", hours_of(averaged->averaging)},
      {"holds_part_of_the_tide", averaged->holds_part_of_the_tide},
      {"unresolved_tide_m_s",
       averaged->unresolved_tide_m_s ? json(*averaged->unresolved_tide_m_s) : json(nullptr)},
      {"tidal_record",
       averaged->tidal_record.empty() ? json(nullptr) : json(averaged->tidal_record)}};
  return object.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::optional<AveragedCurrents> averaged_from(std::string_view text) {
  const json document = json::parse(text, nullptr, false);
  if (document.is_null()) return std::nullopt;
  if (!document.is_object()) refuse("found no such object");
  try {
    return averaged_of(document);
  } catch (const json::exception& problem) {
    refuse(problem.what());
  }
}

}  // namespace slackwater::ingest
