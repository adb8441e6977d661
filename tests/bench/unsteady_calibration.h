#pragma once
#include "tests/bench/bench_report.h"

namespace slackwater::bench {

/// One column-day of the unsteady model, from its wind and currents to its covariance.
void bench_unsteady_day(BenchReport& report);

/// A thousand of them on two threads.
void bench_thousand_columns(BenchReport& report);

/// The least-squares problem of one column-day beside scipy.optimize.least_squares on the same
/// residuals, start, bounds and final cost (scipy_calibration.py). Skipped where python3-scipy is
/// missing.
void bench_against_scipy(BenchReport& report);

}  // namespace slackwater::bench
