#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ingest/cf/trajectory_file.h"
#include "twin/account/vehicle_account.h"

// The account of a run as tables of its log. What is written here is what `account_in` reads.

namespace slackwater::api {

/// A number of a vehicle's account that has a column of the table `fate`.
struct AccountColumn {
  const char* name;
  const char* units;
  const char* meaning;
  std::function<double(const twin::VehicleAccount&)> get;  ///< NaN: there is none
  std::function<void(twin::VehicleAccount&, double)> set;  ///< null: the rows of the log tell it
};
[[nodiscard]] std::span<const AccountColumn> account_columns();

/// A word for what a table has to say nothing about.
inline constexpr const char* no_word = "-";

/// * `fate`: a row a vehicle: its makeup, how it ended and with what margins;
/// * `befell`: what befell vehicles, causes first; `mission`: what those that conduct themselves
///   did. A row an event, by vehicle and time; words for programs and for people;
/// * `approach`: how near something came, a row for each kind; `clearance`: how often those that
///   keep clear raised an alarm, by its cause;
/// * `cleaned`: what was cleaned in all; `cleaning`: the same by bands of depth;
/// * `inspected`, `inspected_surface`, `defect_kind`: what inspections come to, without their
///   patches and findings (api/log/inspection_log.h);
/// * `manoeuvre`, `order`: what manoeuvres ordered, when (api/log/manoeuvre_tables.h).
/// Those that nobody has to do with have no rows.
[[nodiscard]] std::vector<ingest::TrajectoryTable> account_tables(const twin::RunAccount& account);

/// "vessel without warning": an alarm's cause for people.
[[nodiscard]] const char* words_of(twin::AlarmCause cause) noexcept;
/// "from_vehicle": the column of the table `clearance`.
[[nodiscard]] std::string column_of(twin::AlarmCause cause);

/// A kind of approach by the word of the log.
struct ApproachKind {
  const char* name;
  std::optional<twin::Approach> twin::Closest::*of;
};
[[nodiscard]] std::span<const ApproachKind> approach_kinds() noexcept;

}  // namespace slackwater::api
