#include "api/show/vehicle/check_tables.h"

#include <algorithm>
#include <cmath>

#include "api/show/rehearse/manoeuvre_report.h"
#include "fields/base/constants.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using constants::degree;
using constants::gravity_m_s2;
using twin::VehicleKind;

using Row = std::vector<std::string>;

std::string kind_text(VehicleKind kind) {
  switch (kind) {
    case VehicleKind::rov:
      return "ROV";
    case VehicleKind::auv:
      return "AUV";
    case VehicleKind::uav:
      return "multirotor";
    case VehicleKind::usv:
      return "USV";
    case VehicleKind::vessel:
      break;
  }
  return "vessel";
}

std::string battery_text(const twin::Vehicle& vehicle) {
  if (vehicle.battery)
    return formatted("{:.0f} Wh", twin::open_circuit_energy_j(*vehicle.battery, 1, 0) / 3600);
  return twin::burns_fuel(vehicle) ? "none: it burns fuel"
                                   : "none described: its energy is told, and never runs out";
}

void add_afloat(const VehicleCheck& check, std::vector<Row>& rows) {
  const twin::Balance& b = check.balance;
  rows.push_back({"draught", formatted("{:.3f} m", b.draught_m)});
  rows.push_back({"metacentric height GM, across", formatted("{:.3f} m", b.stability_m)});
  rows.push_back({"metacentric height GM, along", formatted("{:.3f} m", b.stability_long_m)});
  rows.push_back({"least freeboard", formatted("{:.3f} m", b.least_freeboard_m)});
}

void add_submerged(const VehicleCheck& check, std::vector<Row>& rows) {
  const twin::Balance& b = check.balance;
  const double weight_n = check.vehicle.body.mass_kg * gravity_m_s2;
  rows.push_back({"net buoyancy", formatted("{:+.2f} N, {:+.2f} % of its weight", b.net_buoyancy_n,
                                            100 * b.net_buoyancy_n / weight_n)});
  rows.push_back({"BG, buoyancy above gravity", formatted("{:.4f} m", b.stability_m)});
}

ReportTable at_rest(const VehicleCheck& check) {
  ReportTable table;
  table.title = "At rest";
  table.columns = {"what", "value"};
  std::vector<Row>& rows = table.rows;
  rows.push_back({"kind", kind_text(check.vehicle.kind)});
  rows.push_back({"mass", formatted("{:.4g} kg", check.vehicle.body.mass_kg)});
  rows.push_back({"battery", battery_text(check.vehicle)});
  rows.push_back({"hotel load", formatted("{:.4g} W", check.vehicle.hotel_w)});
  if (check.flies()) return table;
  check.floats() ? add_afloat(check, rows) : add_submerged(check, rows);
  rows.push_back(
      {"heel at rest, to starboard", formatted("{:.2f} degrees", check.balance.heel_rad / degree)});
  rows.push_back(
      {"trim at rest, bow down", formatted("{:.2f} degrees", check.balance.trim_rad / degree)});
  return table;
}

/// "grows e-fold in 2.4 s" of the mode that grows fastest; else how slowly the slowest fades.
std::string plane_text(const std::vector<std::complex<double>>& modes) {
  constexpr double slowest_per_s = 1.0 / 600;
  const double rate = modes.empty() ? 0 : modes.front().real();
  if (rate > slowest_per_s) return formatted("grows e-fold in {:.2g} s", 1 / rate);
  return "stable";
}

std::string course_text(const twin::KeptCourse& course, bool floats) {
  if (course.over_at_s) return formatted("goes over after {:.0f} s", *course.over_at_s);
  const char* const verdict = !course.is_judged ? "too slow to be judged"
                              : is_lost(course) ? "lost"
                              : is_kept(course) ? "kept"
                                                : "poorly";
  return formatted("{}: {:.1f} deg, {}, {:.2f} m/s", verdict, course.heading_off_rad / degree,
                   floats ? "-" : formatted("{:.2f} m", course.depth_off_m), course.made_m_s);
}

std::string speed_text(const AtSpeed& at) {
  return formatted("{:.3g}{}", at.speed_m_s,
                   at.is_cruise ? " (cruise)"
                   : at.is_top  ? " (top)"
                                : "");
}

ReportTable by_speed(const VehicleCheck& check) {
  ReportTable table;
  const bool has_battery = check.vehicle.battery.has_value();
  table.title = "By speed";
  table.columns = {"m/s", "power W"};
  if (has_battery) table.columns.insert(table.columns.end(), {"lasts h", "range km"});
  if (check.vehicle.kind == VehicleKind::auv)
    table.columns.insert(table.columns.end(), {"pitch deg", "elevator deg"});
  if (!check.flies())
    table.columns.insert(table.columns.end(),
                         {"by itself: depth and pitch", "by itself: course and roll",
                          "by its autopilot: off course, off depth, speed"});
  for (const AtSpeed& at : check.speeds) {
    Row row{speed_text(at), formatted("{:.0f}", at.power_w)};
    if (has_battery) {
      row.push_back(formatted("{:.2f}", at.lasts_s.value_or(0) / 3600));
      row.push_back(formatted("{:.2f}", at.range_m.value_or(0) / 1000));
    }
    if (at.level) {
      row.push_back(formatted("{:+.1f}", at.level->pitch_rad / degree));
      row.push_back(formatted("{:+.1f} of {:.1f}{}", at.level->elevator_rad / degree,
                              check.vehicle.elevator.limit_rad / degree,
                              at.level->is_held ? "" : ": not held"));
    }
    if (at.modes) {
      row.push_back(plane_text(at.modes->vertical));
      row.push_back(plane_text(at.modes->horizontal));
    }
    if (at.course) row.push_back(course_text(*at.course, check.floats()));
    table.rows.push_back(std::move(row));
  }
  table.note = check.flies() ? "Through still air."
                             : "Through still water. By itself: with its controls held. By its "
                               "autopilot: at most, after half of the time that it had.";
  return table;
}

/// "-0.42 +- 0.31i": 1/s.
std::string modes_text(const std::vector<std::complex<double>>& modes) {
  std::vector<std::string> all;
  all.reserve(modes.size());
  for (const std::complex<double>& mode : modes)
    all.push_back(mode.imag() > 0 ? formatted("{:.3g} \u00b1 {:.3g}i", mode.real(), mode.imag())
                                  : formatted("{:.3g}", mode.real()));
  return joined(all, ", ");
}

ReportTable modes(const VehicleCheck& check) {
  ReportTable table;
  table.title = "Eigenvalues, 1/s";
  table.columns = {"m/s", "depth, pitch, u, w, q", "roll, v, p, r"};
  for (const AtSpeed& at : check.speeds)
    if (at.modes)
      table.rows.push_back(
          {speed_text(at), modes_text(at.modes->vertical), modes_text(at.modes->horizontal)});
  table.note = "Of its motion about the straight and level way, its controls held. Above 0: grows.";
  return table;
}

std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U;  // not the rest of a UTF-8 letter
  }));
}

std::string row_text(const Row& row, const std::vector<std::size_t>& widths) {
  std::string text = " ";
  for (std::size_t i = 0; i < row.size(); ++i) {
    text += " " + row[i];
    if (i + 1 < row.size()) text += std::string(widths[i] - width_of(row[i]) + 1, ' ');
  }
  return text + "\n";
}

}  // namespace

std::vector<ReportTable> check_tables(const VehicleCheck& check) {
  std::vector<ReportTable> tables{at_rest(check), by_speed(check)};
  if (!check.flies()) tables.push_back(modes(check));
  return tables;
}

std::string figures_of(const FlownManoeuvre& manoeuvre) {
  std::vector<std::string> said;
  if (manoeuvre.account) said.push_back(manoeuvre_text(*manoeuvre.account));
  if (!manoeuvre.why_not.empty())
    said.push_back((manoeuvre.account ? "" : "not flown: ") + manoeuvre.why_not);
  return joined(said, "; ");
}

std::string check_verdict(const VehicleCheck& check) {
  std::string top = formatted("makes {:.3g} m/s at most", check.top_speed_m_s);
  if (check.flies()) return top;
  std::vector<std::string> loses;
  for (const AtSpeed& at : check.speeds)
    if (at.course && !is_kept(*at.course)) loses.push_back(formatted("{:.3g}", at.speed_m_s));
  const std::string alone = twin::words_of(check.open_loop);
  const char* const way = check.floats() ? "its course" : "its course and its depth";
  return top +
         (loses.empty()
              ? formatted("; its autopilot keeps {} at the speeds below", way)
              : formatted("; its autopilot does not keep {} at {} m/s", way, joined(loses, ", "))) +
         (alone.empty() ? "; with its controls held it goes straight at its cruise speed"
                        : "; " + alone);
}

std::string tables_text(const std::vector<ReportTable>& tables) {
  std::string text;
  for (const ReportTable& table : tables) {
    std::vector<std::size_t> widths;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      widths.push_back(width_of(table.columns[i]));
      for (const Row& row : table.rows) widths[i] = std::max(widths[i], width_of(row[i]));
    }
    text += table.title + "\n" + row_text(table.columns, widths);
    for (const Row& row : table.rows) text += row_text(row, widths);
    if (!table.note.empty()) text += "  " + table.note + "\n";
    text += "\n";
  }
  return text;
}

}  // namespace slackwater::api
