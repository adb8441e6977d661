#include "api/log/command_tables.h"

#include <cmath>
#include <unordered_map>

#include "fields/base/error.h"
#include "twin/run/command_numbers.h"

namespace slackwater::api {
namespace {

using ingest::TrajectoryTable;
using twin::Command;
using twin::RefusalCount;

[[noreturn]] void refuse(const std::string& what) {
  throw Error(ErrorKind::invalid_input,
              what + "; give a log that `slackwater live` or `simulate` wrote");
}

/// Sources by the order in which they came first.
class Clients {
 public:
  double index_of(const std::string& source) {
    const auto [known, is_new] = indices_.try_emplace(source, names_.size());
    if (is_new) names_.push_back(source);
    return static_cast<double>(known->second);
  }
  [[nodiscard]] TrajectoryTable table() const {
    return {"client", {}, {{"name", "which door a command came by, and from whom", names_}}};
  }

 private:
  std::vector<std::string> names_;
  std::unordered_map<std::string, std::size_t> indices_;
};

TrajectoryTable command_table(std::span<const Command> commands, double step_s, Clients& clients,
                              std::vector<double>& contents) {
  std::vector<double> step, time, vehicle, client, sequence, received, numbers;
  std::vector<std::string> kind;
  for (const Command& command : commands) {
    const std::vector<double> content = twin::numbers_of(command.what);
    step.push_back(static_cast<double>(command.step));
    time.push_back(static_cast<double>(command.step) * step_s);
    vehicle.push_back(static_cast<double>(command.agent));
    client.push_back(clients.index_of(command.source));
    sequence.push_back(static_cast<double>(command.sequence));
    received.push_back(command.received_s);
    numbers.push_back(static_cast<double>(content.size()));
    kind.emplace_back(twin::name_of(command.what));
    contents.insert(contents.end(), content.begin(), content.end());
  }
  return {"command",
          {{"step", "1", "of the run before which it took effect", step},
           {"time", "s", "when that was, since the start of the run", time},
           {"vehicle", "1", "index of the trajectory", vehicle},
           {"client", "1", "index of the client that it came from", client},
           {"sequence", "1", "the client's own count", sequence},
           {"received", "s", "when it came in, since the start of the run", received},
           {"numbers", "1", "how many rows of content are of it, one command after the other",
            numbers}},
          {{"kind", "what was asked for", kind}}};
}

TrajectoryTable refusal_table(std::span<const RefusalCount> refusals) {
  std::vector<double> count, time;
  std::vector<std::string> source, vehicle, reason, text;
  for (const RefusalCount& refusal : refusals) {
    count.push_back(static_cast<double>(refusal.count));
    time.push_back(refusal.last_s);
    source.push_back(refusal.source);
    vehicle.push_back(refusal.vehicle);
    reason.emplace_back(twin::name_of(refusal.reason));
    text.push_back(refusal.last_text);
  }
  return {"refusal",
          {{"count", "1", "how many commands were refused so", count},
           {"time", "s", "of the last of them, since the start of the run", time}},
          {{"source", "from whom they came", source},
           {"vehicle", "whom they were for", vehicle},
           {"reason", "why they were refused", reason},
           {"text", "the answer to the last of them", text}}};
}

const std::vector<double>& numbers_in(const TrajectoryTable& table, const char* name) {
  const std::vector<double>* column = table.column(name);
  if (column == nullptr || column->size() != table.rows())
    refuse("found no column " + std::string(name) + " in the table " + table.name);
  return *column;
}

const std::vector<std::string>& texts_in(const TrajectoryTable& table, const char* name) {
  const std::vector<std::string>* column = table.text(name);
  if (column == nullptr || column->size() != table.rows())
    refuse("found no text " + std::string(name) + " in the table " + table.name);
  return *column;
}

/// A count that a double holds exactly, below a bound.
std::uint64_t whole(double value, double below, const char* what, std::size_t row) {
  if (value >= 0 && value < below && value == std::floor(value))
    return static_cast<std::uint64_t>(value);
  refuse("found " + std::to_string(value) + " for the " + what + " of command " +
         std::to_string(row));
}

}  // namespace

std::vector<TrajectoryTable> command_tables(std::span<const Command> commands,
                                            std::span<const RefusalCount> refusals, double step_s) {
  std::vector<TrajectoryTable> tables;
  if (!commands.empty()) {
    Clients clients;
    std::vector<double> contents;
    TrajectoryTable taken = command_table(commands, step_s, clients, contents);
    tables.push_back(clients.table());
    tables.push_back(std::move(taken));
    tables.push_back(
        {"content", {{"value", "1", "a number of a command, as its kind has it", contents}}, {}});
  }
  if (!refusals.empty()) tables.push_back(refusal_table(refusals));
  return tables;
}

std::vector<Command> commands_in(const ingest::TrajectoryFile& log) {
  const TrajectoryTable* table = log.find_table("command");
  if (table == nullptr) return {};
  const TrajectoryTable* clients = log.find_table("client");
  if (clients == nullptr) refuse("found commands without a table of their clients");
  const TrajectoryTable* content = log.find_table("content");
  const std::vector<double> none;
  const std::vector<double>& values = content == nullptr ? none : numbers_in(*content, "value");
  const auto& names = texts_in(*clients, "name");
  const auto &step = numbers_in(*table, "step"), &vehicle = numbers_in(*table, "vehicle"),
             &client = numbers_in(*table, "client"), &sequence = numbers_in(*table, "sequence"),
             &received = numbers_in(*table, "received"), &numbers = numbers_in(*table, "numbers");
  const auto& kind = texts_in(*table, "kind");
  constexpr double beyond = 9007199254740992.0;  // 2^53
  const auto vehicles = static_cast<double>(log.names.size());
  std::span<const double> left = values;
  std::vector<Command> commands;
  for (std::size_t i = 0; i < table->rows(); ++i) {
    Command command;
    command.step = whole(step[i], beyond, "step", i);
    command.agent = whole(vehicle[i], vehicles, "vehicle", i);
    command.source = names[whole(client[i], static_cast<double>(names.size()), "client", i)];
    command.sequence = whole(sequence[i], beyond, "sequence", i);
    command.received_s = received[i];
    const std::size_t count = whole(numbers[i], static_cast<double>(left.size() + 1), "numbers", i);
    command.what = twin::what_of(kind[i], left.first(count));
    left = left.subspan(count);
    commands.push_back(std::move(command));
  }
  if (!left.empty()) refuse("found numbers that are of no command");
  return commands;
}

std::vector<RefusalCount> refusals_in(const ingest::TrajectoryFile& log) {
  const TrajectoryTable* table = log.find_table("refusal");
  if (table == nullptr) return {};
  const auto &count = numbers_in(*table, "count"), &time = numbers_in(*table, "time");
  const auto &source = texts_in(*table, "source"), &vehicle = texts_in(*table, "vehicle"),
             &reason = texts_in(*table, "reason"), &text = texts_in(*table, "text");
  std::vector<RefusalCount> refusals;
  for (std::size_t i = 0; i < table->rows(); ++i) {
    const auto known = twin::refusal_reason_of(reason[i]);
    if (!known) refuse("found " + reason[i] + " for the reason of a refusal");
    refusals.push_back(
        {source[i], vehicle[i], *known, whole(count[i], 1e15, "count", i), time[i], text[i]});
  }
  return refusals;
}

}  // namespace slackwater::api
