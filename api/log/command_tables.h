#pragma once
#include <span>
#include <string>
#include <vector>

#include "ingest/cf/trajectory_file.h"
#include "twin/helm/command_arbiter.h"
#include "twin/run/command.h"

namespace slackwater::api {

/// What people and programs did to the vehicles of a run, as tables of its log; none where nobody
/// did anything.
///
/// | table     | a row each                                                                      |
/// |-----------|---------------------------------------------------------------------------------|
/// | `client`  | source of commands: its `name`                                                  |
/// | `command` | that was taken, in order: `step` before which it took effect and its `time`,    |
/// |           | `vehicle` (index of the trajectory), `client` (index), `sequence`, `received`,  |
/// |           | `kind`, and how many rows of `content` are its own                              |
/// | `content` | number of a command, one command after the other: what they are by kind is in   |
/// |           | twin/run/command_numbers.h                                                 |
/// | `refusal` | source, vehicle and reason for which commands were refused: `count`, the `time` |
/// |           | of the last one and the `text` of the answer to it                              |
///
/// @param step_s  of the barrier
[[nodiscard]] std::vector<ingest::TrajectoryTable> command_tables(
    std::span<const twin::Command> commands, std::span<const twin::RefusalCount> refusals,
    double step_s);

/// The commands of a log, to the last bit as they were taken.
/// @throws Error(invalid_input) for tables that do not fit each other
[[nodiscard]] std::vector<twin::Command> commands_in(const ingest::TrajectoryFile& log);
/// @throws as `commands_in`
[[nodiscard]] std::vector<twin::RefusalCount> refusals_in(const ingest::TrajectoryFile& log);

}  // namespace slackwater::api
