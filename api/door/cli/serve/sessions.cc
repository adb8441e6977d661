#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "api/door/cli/command.h"
#include "api/door/cli/output_file.h"
#include "api/door/live/action_bag.h"
#include "api/door/people/told.h"
#include "data/store/store.h"
#include "fields/base/encode/csv.h"
#include "fields/base/text.h"
#include "fields/base/whole_file.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

struct SessionsArguments {
  std::optional<std::int64_t> session;
  std::string csv, bag;
};

std::string csv_of(const std::vector<store::SessionAction>& actions) {
  std::string csv =
      "number,at,time_s,step,seat,who,role,what,vehicle,before,after,taken,reason,why,count\n";
  for (const store::SessionAction& a : actions)
    csv += joined(std::vector<std::string>{std::to_string(a.number), format_utc(a.at),
                                           csv_cell(a.time_s), std::to_string(a.step),
                                           std::to_string(a.seat), csv_cell_of_people(a.who),
                                           a.role, csv_cell(a.what), csv_cell_of_people(a.vehicle),
                                           csv_cell(a.before), csv_cell_of_people(a.after),
                                           a.is_taken ? "1" : "0", a.reason, csv_cell(a.why),
                                           std::to_string(a.count)},
                  ",") +
           "\n";
  return csv;
}

void list_sessions(store::Store& store, const Context& context) {
  const auto sessions = store.list_sessions();
  if (context.json) {
    json all = json::array();
    for (const store::SessionRow& row : sessions)
      all.push_back({{"session", row.id},
                     {"name", row.name},
                     {"begun", format_utc(row.begun)},
                     {"actions", row.actions}});
    std::printf("%s\n", people::text_of({{"sessions", all}}).c_str());
    return;
  }
  if (sessions.empty()) std::printf("no sessions; `slackwater live --people PORT` begins one\n");
  for (const store::SessionRow& row : sessions)
    std::printf("%4lld  %s  %6llu actions  %s\n", static_cast<long long>(row.id),
                format_utc(row.begun).c_str(), static_cast<unsigned long long>(row.actions),
                row.name.c_str());
}

void show_session(store::Store& store, const SessionsArguments& arguments, const Context& context) {
  const auto actions = store.find_actions(*arguments.session);
  if (!arguments.csv.empty()) write_text(arguments.csv, csv_of(actions));
  if (!arguments.bag.empty()) live::write_action_bag(arguments.bag, actions);
  if (context.json) {
    json rows = json::array();
    for (const store::SessionAction& action : actions) rows.push_back(people::action_json(action));
    std::printf("%s\n", people::text_of({{"actions", rows}}).c_str());
    return;
  }
  for (const store::SessionAction& a : actions)
    std::printf("%9.2f s  %-16s %-10s %-12s %-16s %s%s\n", a.time_s, a.who.c_str(), a.role.c_str(),
                a.what.c_str(), a.vehicle.c_str(),
                a.is_taken ? a.after.c_str() : "refused: ", a.is_taken ? "" : a.why.c_str());
}

void run_sessions(const SessionsArguments& arguments, const Context& context) {
  expect_output("--csv", arguments.csv, {".csv"});
  expect_output("--bag", arguments.bag, {".mcap"});
  if (!arguments.session && (!arguments.csv.empty() || !arguments.bag.empty())) {
    const bool is_csv = !arguments.csv.empty();
    throw Error(ErrorKind::usage,
                formatted("{0}: found no session; name one, e.g. slackwater sessions 1 {0} {1}",
                          is_csv ? "--csv" : "--bag", is_csv ? "actions.csv" : "actions.mcap"));
  }
  store::Store store = store::Store::open(context.store_folder, store::OpenMode::read_only);
  if (arguments.session) return show_session(store, arguments, context);
  list_sessions(store, context);
}

}  // namespace

void add_sessions(CLI::App& app, Context& context) {
  auto arguments = std::make_shared<SessionsArguments>();
  CLI::App* command = app.add_subcommand(
      "sessions", "Live runs in which people took part, and what each of them did");
  command->add_option("session", arguments->session, "number of one; without it all are listed");
  command->add_option("--csv", arguments->csv, "what was done also as FILE.csv, a row each");
  command->add_option("--bag", arguments->bag,
                      "the same as a bag FILE.mcap, a message each on /slackwater/session/actions");
  command->callback([arguments, &context] { run_sessions(*arguments, context); });
}

}  // namespace slackwater::api
