#include "api/show/perception/detection_sheet.h"

#include <algorithm>

#include "fields/base/check.h"
#include "fields/base/text.h"

namespace slackwater::api {

std::string detection_sheet(const MeasuredPod& pod, const std::string& detector) {
  expects(pod.fit.has_value(), "a sheet is of a fitted curve");
  const twin::HitMissFit& fit = *pod.fit;
  return formatted(
      "# Written by `slackwater detect --score FOLDER --pod FOLDER`. In 95 of 100 such trials half "
      "of them are found from\n"
      "# {:.1f} to {:.1f} mm, nine of ten from {:.1f} to {:.1f} mm, and b is {:.2f} to {:.2f}. It "
      "holds for rendered pictures of one stage alone.\n"
      "name: {} by {}, on renders\n"
      "source: measured on renders ({} of {} planted defects found); how well renders stand for "
      "the sea is not known\n"
      "status: estimate\n"
      "finds: [{}]\n"
      "by: [rgb]\n"
      "log_logistic: {{x0_mm: {:.4g}, b: {:.4g}}}\n"
      "at_detail_mm: {:.4g}\n"
      "false_alarms_per_100_m2: {:.4g}\n"
      "size_error: {{relative_sd: {:.3f}, relative_bias: {:.3f}}}\n",
      1e3 * fit.x0.low, 1e3 * fit.x0.high, 1e3 * fit.a90.low, 1e3 * fit.a90.high, fit.b.low,
      fit.b.high, name_of(pod.kind), detector, fit.hits, fit.looks, name_of(pod.kind),
      1e3 * fit.curve.x0, fit.curve.b, 1e3 * pod.at_detail_m, false_alarms_per_100_m2(pod),
      pod.size_sd, pod.size_bias);
}

}  // namespace slackwater::api
