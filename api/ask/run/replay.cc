#include <unistd.h>

#include <bit>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>

#include "api/ask/run/heard_traffic.h"
#include "api/ask/run/log_file.h"
#include "api/log/action_tables.h"
#include "api/log/command_tables.h"
#include "api/log/detection_log.h"
#include "api/program/version.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "ingest/apart/read_tracks_apart.h"

namespace slackwater::api {
namespace {

using ingest::TrajectoryFile;

/// A file beside the log that goes when its owner does.
class Scratch {
 public:
  explicit Scratch(const std::string& name)
      : path_(std::filesystem::temp_directory_path() /
              ("slackwater-" + name + "-" + std::to_string(::getpid()) + ".nc")) {}
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_;
};

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw Error(ErrorKind::not_found, "no log at " + file.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// The first column of a list beside the tracks that is another one.
std::string difference_of_tables(const TrajectoryFile& was, const TrajectoryFile& is) {
  for (const ingest::TrajectoryTable& table : is.tables) {
    if (table.rows() == 0) continue;
    const ingest::TrajectoryTable* logged = was.find_table(table.name);
    if (logged == nullptr || logged->rows() != table.rows())
      return "table " + table.name + ": the log has " +
             std::to_string(logged == nullptr ? 0 : logged->rows()) + " rows, the run " +
             std::to_string(table.rows());
    for (const auto& column : table.columns) {
      const std::vector<double>* other = logged->column(column.name);
      for (std::size_t i = 0; i < table.rows(); ++i)
        if (other == nullptr || other->size() <= i || !same_bits((*other)[i], column.values[i]))
          return table.name + "_" + column.name + " parts in row " + std::to_string(i);
    }
  }
  return {};
}

/// Where two logs part, in words.
std::string difference_of(const TrajectoryFile& was, const TrajectoryFile& is) {
  for (const auto& [name, text] : was.attributes) {
    if (is.attribute(name) != text && name != "source")
      return "attribute " + name + ": found '" + is.attribute(name) + "', the log has '" + text +
             "'";
  }
  if (was.t_s != is.t_s)
    return "the log has " + std::to_string(was.t_s.size()) + " times, the run " +
           std::to_string(is.t_s.size());
  // The first time at which anything differs says most.
  for (std::size_t t = 0; t < was.t_s.size(); ++t) {
    for (const TrajectoryFile::Variable& v : was.variables) {
      const auto* other = is.find(v.name);
      if (other == nullptr || other->values.size() != v.values.size())
        return "variable " + v.name + " is not in the run";
      for (std::size_t thing = 0; thing < was.names.size(); ++thing) {
        for (std::size_t k = 0; k < v.per; ++k) {
          const std::size_t i = (thing * was.t_s.size() + t) * v.per + k;
          if (same_bits(v.values[i], other->values[i])) continue;
          return formatted("{} of {} at {:g} s: the log has {:.17g}, the run {:.17g}", v.name,
                           was.names[thing], was.t_s[t], v.values[i], other->values[i]);
        }
      }
    }
  }
  if (std::string parts = difference_of_tables(was, is); !parts.empty()) return parts;
  if (was.attribute("source") != is.attribute("source"))
    return "all numbers are the same; the log is of " + was.attribute("source") + ", this is " +
           is.attribute("source");
  return "the files differ in bytes that are no numbers of the run";
}

/// What was done to the run from outside.
RunRecord record_in(const TrajectoryFile& log) {
  RunRecord record{commands_in(log), refusals_in(log), {}, actions_in(log)};
  const std::string stopped = log.attribute("stopped_at_step");
  if (stopped.empty()) return record;
  std::uint64_t step = 0;
  const auto [end, problem] =
      std::from_chars(stopped.data(), stopped.data() + stopped.size(), step);
  if (problem != std::errc() || end != stopped.data() + stopped.size())
    throw Error(ErrorKind::invalid_input,
                "found '" + stopped + "' for the step at which it was stopped, expected a number");
  record.stopped_at_step = step;
  return record;
}

/// Of the run alone, without what detectors found in its pictures.
std::string bytes_of_run(const std::filesystem::path& log, const TrajectoryFile& was) {
  TrajectoryFile alone = was;
  if (!take_off_detections(alone)) return bytes_of(log);
  const Scratch scratch("replayed");
  ingest::write_trajectories(alone, scratch.path());
  return bytes_of(scratch.path());
}

}  // namespace

ReplayResult replay(const std::filesystem::path& log, const std::filesystem::path& store_folder,
                    const std::optional<std::filesystem::path>& forecast, const RunChoice& choice,
                    const std::function<void(double)>& on_progress) {
  const auto started = std::chrono::steady_clock::now();
  const TrajectoryFile was = ingest::read_tracks_apart(log);
  const std::string yaml = was.attribute("scenario");
  if (yaml.empty()) {
    throw Error(ErrorKind::invalid_input,
                log.string() + ": holds no scenario; give a log that `slackwater simulate` wrote");
  }
  if (const std::string format = was.attribute("log_format");
      format != std::to_string(twin::log_format)) {
    throw Error(ErrorKind::invalid_input,
                log.string() + ": is a log of format " + (format.empty() ? "1" : format) +
                    ", this version writes format " + std::to_string(twin::log_format) +
                    " with other columns; replay it with the version it is of, " +
                    was.attribute("source"));
  }
  const twin::Scenario scenario = twin::parse_scenario(yaml, log.string() + " (scenario)");
  ScenarioWater water =
      water_of_log(scenario, was.attribute("forecast_sha256"), store_folder, forecast);
  add_logged_traffic(was, scenario, water);
  RunChoice recorded = choice;
  recorded.record = with_context(log.string(), [&] { return record_in(was); });
  const std::string vehicles =
      vehicle_checksums(scenario, water.surround.data_folder, recorded.record.commands);
  if (vehicles != was.attribute("vehicle_files_sha256")) {
    throw Error(ErrorKind::not_found,
                log.string() + ": its vehicles are not those of data/vehicles any more (found " +
                    vehicles + ", the log has " + was.attribute("vehicle_files_sha256") +
                    "); replay it with the version it is of, " + was.attribute("source"));
  }
  const ScenarioResult again = run_scenario(scenario, water, recorded, on_progress);
  const Scratch scratch("replay");
  ingest::write_trajectories(again.file, scratch.path());
  ReplayResult result;
  result.is_identical = bytes_of_run(log, was) == bytes_of(scratch.path());
  if (!result.is_identical) result.difference = difference_of(was, again.file);
  result.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  return result;
}

}  // namespace slackwater::api
