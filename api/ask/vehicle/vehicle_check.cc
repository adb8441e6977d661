#include "api/ask/vehicle/vehicle_check.h"

#include "api/ask/vehicle/manoeuvres_of_check.h"
#include "api/ask/vehicle/speeds_of_check.h"
#include "twin/handling/handling_findings.h"
#include "twin/run/set_up.h"
#include "twin/vehicle/own_autopilot.h"
#include "twin/vehicle/top_speed.h"

namespace slackwater::api {

VehicleCheck check_vehicle(const std::string& model, const std::filesystem::path& data_folder) {
  VehicleCheck check;
  check.file = twin::vehicle_file(model, data_folder);
  check.vehicle = twin::read_handled_vehicle(check.file, data_folder);
  const twin::Vehicle& vehicle = check.vehicle;
  const double voltage_v = twin::usual_voltage_v(vehicle);
  const twin::Autopilot autopilot = twin::own_autopilot(vehicle, vehicle.autopilot, voltage_v);
  check.top_speed_m_s = twin::top_speed_m_s(vehicle, autopilot, voltage_v, true);
  check.speeds = speeds_of_check(vehicle, autopilot, check.top_speed_m_s);
  if (check.flies()) return check;
  check.balance = twin::balance_of(vehicle);
  check.open_loop = twin::open_loop_of(vehicle);
  check.manoeuvres = manoeuvres_of_check(vehicle, autopilot, check.file);
  return check;
}

}  // namespace slackwater::api
