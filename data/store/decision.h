#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "fields/base/time.h"

namespace slackwater::store {

/// What a person decided about a start.
enum class Decided { go, no_go };
/// "go", "no_go".
[[nodiscard]] std::string_view name_of(Decided decided) noexcept;
/// Throws Error(invalid_input).
[[nodiscard]] Decided decided_from(std::string_view name);

/// How much of a name and of a note a record takes, characters; the schema says the same.
inline constexpr std::size_t longest_name = 200;
inline constexpr std::size_t longest_note = 2000;

/// A decision as it was recorded. Of those of one site, task, turbine and start the one filed last
/// (the greatest id) counts; the others stay.
struct DecisionRow {
  std::int64_t id = 0;  ///< given by the store, in the order of filing
  std::string site_id;
  std::string task;     ///< id of data/tasks, or the path of a sheet
  std::string turbine;  ///< empty where the work has none
  UtcTime start{};
  std::optional<Duration> work;  ///< from the start to the end of its contingency, where known
  Decided decided = Decided::no_go;
  std::string by;  ///< the name of who decided, not blank
  UtcTime recorded_at{};
  bool by_clock = true;               ///< false: the time of record was stated, not read
  std::int64_t forecast = 0;          ///< id of the forecast that was decided on
  std::string forecast_sha256;        ///< given by the store: of its content
  UtcTime forecast_issued{};          ///< given by the store
  std::optional<double> probability;  ///< that all limits hold, as it was said; absent: see unsaid
  std::string verdict;                ///< "go", "marginal", "no-go" of that start; else empty
  std::string unsaid;                 ///< why nothing was said of it
  std::string note;                   ///< why
  std::string hand_over;  ///< what the next shift is to know; one line, as long as a note
  bool operator==(const DecisionRow&) const = default;
};

/// Which decisions are wanted; what is not set does not restrict.
struct DecisionQuery {
  std::string site_id;          ///< empty: all sites
  std::string task;             ///< empty: all tasks
  std::optional<UtcTime> from;  ///< of the start
  std::optional<UtcTime> to;    ///< not itself in
};

}  // namespace slackwater::store
