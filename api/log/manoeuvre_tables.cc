#include "api/log/manoeuvre_tables.h"

#include <algorithm>

#include "api/log/table_reader.h"
#include "api/log/table_rows.h"

namespace slackwater::api {
namespace {

using twin::ManoeuvreAccount;
using twin::Ordered;
using twin::TaskOrder;

TableRows manoeuvre_rows() {
  return {
      "manoeuvre",
      {{"vehicle", "1", "which of the trajectories, from 0", {}},
       {"task", "1", "of its tasks, from 0", {}},
       {"by_rudder", "1", "1: its helms are rad; 0: shares of the thrusters' yaw moment", {}},
       {"heading_change",
        "rad",
        "of a zig-zag: at which the helm goes over; of a turning circle: after which it is over",
        {}},
       {"helms", "1", "that it has in all", {}},
       {"followed",
        "s",
        "since the start of the run: the last step that it had; 0 where it did not begin",
        {}}},
      {{"kind", "which manoeuvre", {}}}};
}

TableRows order_rows() {
  return {"order",
          {{"vehicle", "1", "which of the trajectories, from 0", {}},
           {"task", "1", "of its tasks, from 0", {}},
           {"time", "s", "since the start of the run", {}},
           {"value", "1", "heading, rad; speed, m/s; depth, m; helm, rad or share; else 0", {}}},
          {{"what", "was ordered, or that it begins or is over", {}}}};
}

ManoeuvreAccount& manoeuvre_at(const TableReader& table, double task,
                               twin::VehicleAccount& vehicle) {
  const auto at =
      std::find_if(vehicle.manoeuvres.begin(), vehicle.manoeuvres.end(),
                   [&](const auto& one) { return static_cast<double>(one.task) == task; });
  if (at == vehicle.manoeuvres.end()) table.refuse("has an order of a task that is no manoeuvre");
  return *at;
}

}  // namespace

std::vector<ingest::TrajectoryTable> manoeuvre_tables(const twin::RunAccount& account) {
  TableRows manoeuvres = manoeuvre_rows(), orders = order_rows();
  for (std::size_t v = 0; v < account.vehicles.size(); ++v) {
    for (const ManoeuvreAccount& one : account.vehicles[v].manoeuvres) {
      const auto vehicle = static_cast<double>(v);
      manoeuvres.add({vehicle, static_cast<double>(one.task), one.by_rudder ? 1.0 : 0.0,
                      one.heading_change_rad, static_cast<double>(one.legs), one.followed_s},
                     {name_of(one.kind)});
      for (const TaskOrder& order : one.orders)
        orders.add({vehicle, order.task, order.t_s, order.value},
                   {name_of(static_cast<Ordered>(order.what))});
    }
  }
  return {manoeuvres.take(), orders.take()};
}

void read_manoeuvres(const ingest::TrajectoryFile& log, twin::RunAccount& account) {
  const TableReader table(log, "manoeuvre");
  table.for_each([&](std::size_t vehicle, std::size_t row) {
    ManoeuvreAccount& one = account.vehicles[vehicle].manoeuvres.emplace_back();
    one.task = table.whole("task", row);
    one.kind = table.named("kind", row, twin::ManoeuvreKind::steps);
    one.by_rudder = table.whole("by_rudder", row) == 1;
    one.heading_change_rad = table.number("heading_change", row);
    one.legs = table.whole("helms", row);
    one.followed_s = table.number("followed", row);
  });
  const TableReader orders(log, "order");
  orders.for_each([&](std::size_t vehicle, std::size_t row) {
    const double task = orders.number("task", row);
    const auto what = orders.named("what", row, Ordered::over);
    manoeuvre_at(orders, task, account.vehicles[vehicle])
        .orders.push_back({orders.number("time", row), task, static_cast<double>(what),
                           orders.number("value", row)});
  });
}

}  // namespace slackwater::api
