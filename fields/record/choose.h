#pragma once
#include <optional>
#include <string>
#include <vector>

#include "fields/record/record.h"
#include "fields/record/stretch.h"

namespace slackwater {

/// What was known when: the glass through which a forecast, a hindcast or a verification looks at
/// the store.
struct Knowledge {
  UtcTime values_until =
      UtcTime::max();  ///< analysed and observed values that end later are unknown
  /// Provider forecasts that were published later (`is_published_by`) are unknown.
  UtcTime forecasts_issued_by = UtcTime::max();
  /// What a file that had been received by then holds is known, whenever it is valid: products that
  /// run on into the future without saying where their forecast begins.
  UtcTime received_by = UtcTime::min();
  /// Where some of a record had been received by then, what was received later is unknown, and of
  /// values that came more than once the last that was there by then counts. Where nothing had (an
  /// archive that was read later), what each value was then cannot be told: the newest that was
  /// published by then is taken, else what there is (`Stretch::may_be_revised`).
  UtcTime seen_by = UtcTime::max();
};

/// Whether a value of this origin and time is seen through the glass, as far as `seen_by` leaves
/// it.
[[nodiscard]] bool is_known(const Origin& origin, const TimeCell& cell, const Knowledge& knowledge);

/// A series chosen from a record.
template <typename T>
struct Chosen {
  Column<T> column;
  std::vector<const Origin*> origin;  ///< per time; after them those that were fused into it
  std::vector<Stretch> stretches;     ///< who speaks when, ascending
  /// Standard deviation of the independent error of each value (of a component), times x levels, as
  /// its instrument states it; empty: nobody does.
  std::vector<double> noise_m_s{};
  [[nodiscard]] bool empty() const noexcept { return column.time.empty(); }
};

/// Which pieces take part, and how they are joined.
struct Choice {
  bool only_forecasts = false;           ///< the provider's own forecast, nothing analysed
  bool only_grids = false;               ///< products, no moored instruments
  bool only_series = false;              ///< moored instruments, no products
  std::optional<std::string> dataset{};  ///< only this dataset
  bool every_series = false;             ///< of instruments not the nearest alone
  /// Over this time a run that takes over from another, or hands over to it, is moved onto it.
  Duration ramp{0};
  /// Not a choice of its own: the runs that speak here speak, each for its time.
  const std::vector<Stretch>* like = nullptr;
};

/// Chooses one series from a record. One run of one product speaks as long as it lasts, then the
/// next best; no two alternate. The order, by the first that tells two runs apart:
///
///   1. analysed or observed before forecast      6. the newer reference time
///   2. a product before an instrument            7. a lone run or the control before the mean of
///   3. one that is said to lack the tide last       an ensemble
///   4. made for a region before global           8. stated nearer to 10 m (winds)
///   5. of finer grid                             9. on more levels, then by name
///
/// A run lasts from its first to its last value; holes in it (cadence.h) are for others, and so is
/// the time between analysed values that the dataset's own, finer forecasts fill (run_steps.h).
/// What is missing stays missing. Of values of one run that came more than once the last published
/// counts, where nobody says when, the last received. Runs on other levels than the best are left
/// out. Members of an ensemble do not speak by themselves: their mean does. Point series at several
/// places are not mixed: where no dataset is asked for, the nearest that has a known value speaks.
///
/// With a ramp the run of lower rank is moved onto the other at a join: by the difference of the
/// two there, fading linearly over the ramp. The series makes no jump there that neither run makes;
/// the values of the higher one stay as they are. The answer is the same for any order of pieces.
[[nodiscard]] Chosen<Horizontal> choose(const VectorRecord& record, const Knowledge& knowledge,
                                        const Choice& choice);
[[nodiscard]] Chosen<double> choose(const ScalarRecord& record, const Knowledge& knowledge,
                                    const Choice& choice);

}  // namespace slackwater
