#include "api/log/checkpoint_file.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "api/log/state_json.h"
#include "data/store/durable.h"
#include "fields/base/encode/sha256.h"
#include "fields/base/error.h"
#include "fields/base/given_file.h"
#include "fields/base/process/run_apart.h"
#include "fields/base/whole_file.h"
#include "ingest/apart/read_apart.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

constexpr std::string_view first_line = "slackwater checkpoint 1\n";
constexpr std::size_t digest_size = 64;
constexpr std::size_t most_bytes = std::size_t{4} << 30U;

void append(std::string& bytes, const std::vector<double>& numbers) {
  bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
}

json head_of(const StandingRun& run, const CheckpointOrigin& origin) {
  json states = json::array();
  for (const twin::AgentState& state : run.checkpoint.states) states.push_back(state_json(state));
  json rows = json::array(), sensor_rows = json::array();
  for (const auto& row : run.log.rows) rows.push_back(row.size());
  for (const auto& row : run.sensor_rows) sensor_rows.push_back(row.size());
  return {{"program", origin.program},
          {"scenario_sha256", origin.scenario_sha256},
          {"forecast_sha256", origin.forecast_sha256},
          {"vehicle_files_sha256", origin.vehicles},
          {"traffic_sha256", origin.traffic_sha256},
          {"steps_made", run.checkpoint.steps_made},
          {"times", run.log.t_s.size()},
          {"rows", rows},
          {"sensor_rows", sensor_rows},
          {"last_sensor_row_s", exact_text(run.last_sensor_row_s)},
          {"watch", watch_json(run.watch)},
          {"states", states},
          {"commands_taken", commands_json(run.checkpoint.taken)},
          {"commands_waiting", commands_json(run.checkpoint.waiting)},
          {"refusals", refusals_json(run.refusals)},
          {"newcomer_files_sha256", run.newcomers}};
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what) {
  throw Error(ErrorKind::invalid_input, file.string() + ": " + what);
}

/// The bytes after the first two lines, whose checksum holds.
std::string checked_bytes(const std::filesystem::path& file) {
  const std::string bytes = text_of_given_file(file, "a checkpoint", most_bytes);
  if (!bytes.starts_with(first_line)) {
    refuse(file,
           bytes.starts_with("slackwater checkpoint ")
               ? "is a checkpoint of another format; take it up with the version that wrote it"
               : "is no checkpoint; give a file that `simulate --checkpoint` wrote");
  }
  const std::size_t body = first_line.size() + digest_size + 1;
  if (bytes.size() < body || sha256_of_text(std::string_view(bytes).substr(body)) !=
                                 std::string_view(bytes).substr(first_line.size(), digest_size))
    refuse(file, "is damaged or cut short: its checksum does not hold; go on from another one");
  return bytes.substr(body);
}

void expect_same(const std::filesystem::path& file, const char* what, const json& found,
                 const std::string& expected) {
  if (found == expected) return;
  const auto shown = [](const std::string& text) { return text.empty() ? "none" : text; };
  refuse(file, "belongs to another " + std::string(what) + ": found " +
                   shown(found.get<std::string>()) + ", this run has " + shown(expected));
}

/// Takes numbers off the end of the file's text, one list after the other.
struct CheckpointRows {
  std::string_view left;
  std::vector<double> take(std::size_t count) {
    if (left.size() / sizeof(double) < count)
      throw Error(ErrorKind::invalid_input, "has fewer rows than it says");
    std::vector<double> out(count);
    if (count > 0) std::memcpy(out.data(), left.data(), count * sizeof(double));
    left.remove_prefix(count * sizeof(double));
    return out;
  }
};

StandingRun run_of(const json& head, std::string_view rows) {
  StandingRun run;
  run.checkpoint.steps_made = head.at("steps_made").get<std::uint64_t>();
  for (const json& state : head.at("states")) run.checkpoint.states.push_back(state_of(state));
  run.checkpoint.taken = commands_of(head.at("commands_taken"));
  run.checkpoint.waiting = commands_of(head.at("commands_waiting"));
  run.watch = watch_of(head.at("watch"));
  run.refusals = refusals_of(head.at("refusals"));
  run.newcomers = head.at("newcomer_files_sha256").get<std::string>();
  CheckpointRows numbers{rows};
  run.log.t_s = numbers.take(head.at("times").get<std::size_t>());
  for (const json& size : head.at("rows"))
    run.log.rows.push_back(numbers.take(size.get<std::size_t>()));
  for (const json& size : head.at("sensor_rows"))
    run.sensor_rows.push_back(numbers.take(size.get<std::size_t>()));
  run.last_sensor_row_s = exact_number(head.at("last_sensor_row_s").get<std::string>());
  return run;
}

StandingRun parsed_checkpoint(const std::filesystem::path& file, const CheckpointOrigin& origin) {
  const std::string body = checked_bytes(file);
  try {
    const std::size_t line = body.find('\n');
    const std::size_t size = std::stoul(body.substr(0, line));
    const json head = json::parse(std::string_view(body).substr(line + 1, size));
    expect_same(file, "scenario (checksum)", head.at("scenario_sha256"), origin.scenario_sha256);
    expect_same(file, "forecast (checksum)", head.at("forecast_sha256"), origin.forecast_sha256);
    expect_same(file, "set of vehicle files (checksums)", head.at("vehicle_files_sha256"),
                origin.vehicles);
    expect_same(file, "traffic (checksum)", head.at("traffic_sha256"), origin.traffic_sha256);
    expect_same(file, "version of the program", head.at("program"), origin.program);
    return run_of(head, std::string_view(body).substr(line + 1 + size));
  } catch (const Error& problem) {
    if (problem.message().starts_with(file.string())) throw;
    refuse(file, problem.message());
  } catch (const std::exception& problem) {
    refuse(file, std::string("holds no state of this program (") + problem.what() + ")");
  }
}

}  // namespace

void write_checkpoint(const StandingRun& run, const CheckpointOrigin& origin,
                      const std::filesystem::path& file) {
  const std::string head = head_of(run, origin).dump(1) + "\n";
  std::string body = std::to_string(head.size()) + "\n" + head;
  append(body, run.log.t_s);
  for (const auto& row : run.log.rows) append(body, row);
  for (const auto& row : run.sensor_rows) append(body, row);
  write_beside(file, [&](const std::filesystem::path& partial) {
    std::ofstream out(partial, std::ios::binary);
    out << first_line << sha256_of_text(body) << '\n' << body;
    out.close();
    if (!out)
      throw Error(ErrorKind::unavailable, "the checkpoint " + file.string() +
                                              " could not be written; free space or name another");
    store::sync_file(partial);
  });
  store::sync_folder(std::filesystem::absolute(file).parent_path());
}

/// It may be a stranger's: it is tried first where it can do no harm.
StandingRun read_checkpoint(const std::filesystem::path& file, const CheckpointOrigin& origin) {
  if (is_alone()) {
    static_cast<void>(ingest::read_apart(file, ingest::allowance_for(file), [&](const TellShare&) {
      static_cast<void>(parsed_checkpoint(file, origin));
      return std::string();
    }));
  }
  return parsed_checkpoint(file, origin);
}

}  // namespace slackwater::api
