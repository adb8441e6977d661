#pragma once
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "fields/base/config.h"
#include "twin/inspection/defect/defect_kind.h"
#include "twin/inspection/instrument/instrument.h"

namespace slackwater::twin {

/// POD(a) = 1 - 1/(1 + (a/X0)^b): half of the defects as large as X0 are found.
struct LogLogisticPod {
  double x0 = 0;  ///< m, or a share
  double b = 0;
};
/// A broken line through points, from nothing at 0, held beyond its last one.
struct PodTable {
  std::vector<double> size;  ///< m, or a share; rising
  std::vector<double> pod;   ///< 0 to 1, not falling
};
/// What is measured and called: POD(a) = Phi((a - a0)/sd), Phi the distribution of a normal error.
/// A defect that hardly is one is found by the error alone, in Phi(-a0/sd) of all cases.
/// MIL-HDBK-1823A, appendix G, has it for signals.
struct NormalErrorPod {
  double called_from = 0;  ///< a0: half of those as large are called; m, or a share
  double sd = 0;           ///< of the measurement, in the same unit
};
using PodCurve = std::variant<LogLogisticPod, PodTable, NormalErrorPod>;
/// Probability of detection: 0 at no size. @param size in the curve's unit, at least 0
[[nodiscard]] double pod_of(const PodCurve& curve, double size) noexcept;

/// What the curve counts as a defect's size.
enum class PodOf {
  size,      ///< its longest side on the surface
  severity,  ///< how far it has gone
};

/// How well an instrument, and who reads it, finds defects of some kinds; as data/detection has it.
struct DetectionMethod {
  std::string name;
  std::vector<DefectKind> finds;
  std::vector<InstrumentKind> by;
  std::vector<SurfaceKind> on;  ///< empty: wherever the kinds can be
  PodOf of = PodOf::size;
  PodCurve curve;
  double at_detail_m = 0;  ///< least detail that was made out where the curve was won
  double false_alarms_per_100_m2 = 0;
  double size_sd = 0;    ///< of a measured size, as a share of the true one
  double size_bias = 0;  ///< the same; above 0: told too large
  std::string source;
  std::string status;

  [[nodiscard]] bool can_find(DefectKind kind, SurfaceKind surface,
                              InstrumentKind instrument) const;
  [[nodiscard]] bool is_used(SurfaceKind surface, InstrumentKind instrument) const;
};

/// Of a defect that was seen with some detail: a look that is worse than those of the curve shrinks
/// the defect as much, a_eff = a min(1, at_detail/detail); a better one brings nothing that nobody
/// measured.
/// @param detail_m  infinite: not seen
[[nodiscard]] double probability_of_detection(const DetectionMethod& method, const Defect& defect,
                                              double detail_m) noexcept;

/// One file of data/detection:
///
///     name: Close visual, moderate access
///     source: ...
///     status: unconfirmed
///     finds: [crack]
///     by: [rgb]
///     on: [tower]                                # absent: wherever the kind can be
///     of: size                                   # or severity
///     log_logistic: {x0_mm: 37.15, b: 0.954}
///     at_detail_mm: 0.5
///     false_alarms_per_100_m2: 0.1
///     size_error: {relative_sd: 0.2, relative_bias: 0}
///
/// or, in the place of log_logistic, `table: {size_mm: [...], pod: [...]}` or
/// `normal_error: {called_from_mm: 312, sd_mm: 156}`. Where the curve is of a severity that is a
/// share, its keys are x0_share, share, called_from_share and sd_share.
/// @throws Error(invalid_input) for a probability outside 0 to 1, one that falls with the size, an
///         X0 or a deviation that is not above 0, lists of unequal lengths, no source, ...
[[nodiscard]] DetectionMethod read_detection_method(const Config& config);

/// The methods of those names, each from FOLDER/detection/NAME.yaml.
/// @throws Error(invalid_input) for a name that is not there, or two methods for one and the same
[[nodiscard]] std::vector<DetectionMethod> read_detection_methods(
    const std::vector<std::string>& names, const std::filesystem::path& data_folder);

/// @throws Error(invalid_input) where two methods find the same kind on the same surface by the
///         same instrument: nobody could say which holds
void expect_one_method_each(const std::vector<DetectionMethod>& methods);

}  // namespace slackwater::twin
