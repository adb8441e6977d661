#include "twin/inspection/defect/detection_method.h"

#include <algorithm>
#include <cmath>

#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::twin {
namespace {

double pod(const LogLogisticPod& curve, double size) noexcept {
  return size > 0 ? 1 - 1 / (1 + std::pow(size / curve.x0, curve.b)) : 0;
}

double pod(const PodTable& table, double size) noexcept {
  double size_below = 0, pod_below = 0;
  for (std::size_t i = 0; i < table.size.size(); ++i) {
    if (size < table.size[i]) {
      const double share = (size - size_below) / (table.size[i] - size_below);
      return pod_below + share * (table.pod[i] - pod_below);
    }
    size_below = table.size[i];
    pod_below = table.pod[i];
  }
  return pod_below;
}

double pod(const NormalErrorPod& curve, double size) noexcept {
  return size > 0 ? 0.5 * std::erfc((curve.called_from - size) / (curve.sd * std::sqrt(2.0))) : 0;
}

template <typename Kind>
bool is_among(const std::vector<Kind>& kinds, Kind kind) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

/// Whether there is a surface on which both would find a kind.
bool meet(const DetectionMethod& a, const DetectionMethod& b, DefectKind kind,
          InstrumentKind instrument) {
  const auto surfaces = surfaces_of(kind);
  return std::any_of(surfaces.begin(), surfaces.end(), [&](SurfaceKind surface) {
    return a.can_find(kind, surface, instrument) && b.can_find(kind, surface, instrument);
  });
}

void expect_apart(const DetectionMethod& a, const DetectionMethod& b) {
  for (const DefectKind kind : a.finds)
    for (const InstrumentKind instrument : a.by)
      if (meet(a, b, kind, instrument))
        throw Error(
            ErrorKind::invalid_input,
            formatted("detection: both \"{}\" and \"{}\" find {} by {} on the same surface; "
                      "leave one of them out",
                      a.name, b.name, name_of(kind), name_of(instrument)));
}

}  // namespace

double pod_of(const PodCurve& curve, double size) noexcept {
  return std::visit([&](const auto& law) { return pod(law, size); }, curve);
}

bool DetectionMethod::is_used(SurfaceKind surface, InstrumentKind instrument) const {
  const bool is_its_surface =
      on.empty() ? std::any_of(finds.begin(), finds.end(),
                               [&](DefectKind kind) { return may_sit_on(kind, surface); })
                 : is_among(on, surface);
  return is_its_surface && is_among(by, instrument);
}

bool DetectionMethod::can_find(DefectKind kind, SurfaceKind surface,
                               InstrumentKind instrument) const {
  return is_among(finds, kind) && may_sit_on(kind, surface) && is_used(surface, instrument);
}

double probability_of_detection(const DetectionMethod& method, const Defect& defect,
                                double detail_m) noexcept {
  const double size = method.of == PodOf::size ? defect.size_m : defect.severity;
  const double shrinks = detail_m > method.at_detail_m ? method.at_detail_m / detail_m : 1;
  return pod_of(method.curve, size * shrinks);
}

void expect_one_method_each(const std::vector<DetectionMethod>& methods) {
  for (std::size_t i = 0; i < methods.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) expect_apart(methods[i], methods[k]);
}

}  // namespace slackwater::twin
