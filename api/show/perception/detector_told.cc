#include "api/show/perception/detector_told.h"

#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

std::string ap_words(const std::optional<ShareWithin>& ap) {
  return ap ? formatted("{:.3f} ({:.3f} to {:.3f})", ap->share, ap->low, ap->high) : "-";
}
std::string percent_words(const std::optional<double>& share) {
  return share ? formatted("{:.0f} %", 100 * *share) : "-";
}
std::string mm_words(const twin::Within95& size) {
  return formatted("{:.0f} ({:.0f} to {:.0f}) mm", 1e3 * size.value, 1e3 * size.low,
                   1e3 * size.high);
}
std::string what_of(const BandScore& band) { return band.by == "range_m" ? "range" : "visibility"; }

json share_or_null(const std::optional<double>& share) { return share ? json(*share) : json(); }
json within_json(const twin::Within95& one) {
  return {{"value", one.value}, {"interval_95", {one.low, one.high}}};
}

}  // namespace

std::string words_of(const DetectorScore& score) {
  std::string out = counted(score.pictures.size(), "picture") + "\n";
  out += formatted("{:<14} {:>7} {:>7}  {:<22} {:>7} {:>10}  {}\n", "kind", "labels", "finds",
                   "AP50 (95 of 100 sets)", "recall", "precision",
                   "false alarms in 100 pictures without a label");
  for (const KindScore& kind : score.kinds)
    out += formatted("{:<14} {:>7} {:>7}  {:<22} {:>7} {:>10}  {}\n", kind.of, kind.labels,
                     kind.found, ap_words(kind.average_precision), percent_words(kind.recall),
                     percent_words(kind.precision),
                     kind.false_alarms_per_100 ? formatted("{:.1f}", *kind.false_alarms_per_100)
                                               : "- (all pictures have labels)");
  if (!score.only_labels.empty())
    out += "Not looked for: " + joined(score.only_labels, ", ") +
           ": the detector does not know them.\n";
  if (!score.only_finds.empty())
    out += "Not scored: " + joined(score.only_finds, ", ") + ": no label is of them.\n";
  return out;
}

std::string words_of(const std::vector<BandScore>& bands) {
  if (bands.empty()) return {};
  std::string out = formatted("\n{:<26} {:<14} {:>7}  {:<22} {:>7} {:>10}\n", "third of the looks",
                              "kind", "labels", "AP50 (95 of 100 sets)", "recall", "precision");
  for (const BandScore& band : bands)
    for (const KindScore& kind : band.kinds)
      out += formatted("{:<26} {:<14} {:>7}  {:<22} {:>7} {:>10}\n",
                       formatted("{} {:.2g} to {:.2g} m", what_of(band), band.from, band.to),
                       kind.of, kind.labels, ap_words(kind.average_precision),
                       percent_words(kind.recall), percent_words(kind.precision));
  return out;
}

std::string words_of(const std::vector<MeasuredPod>& pods) {
  std::string out = formatted("\n{:<14} {:>10} {:>6}  {:<26} {:<26} {:<20} {:>12}  {}\n", "kind",
                              "looked for", "found", "half are found from", "nine of ten from", "b",
                              "at detail", "false alarms in 100 m2");
  for (const MeasuredPod& pod : pods) {
    if (!pod.fit) {
      out += formatted("{:<14} {:>10} {:>6}  no curve: {} to tell small from large\n",
                       name_of(pod.kind), pod.looked_for, pod.found,
                       pod.looked_for < 2 ? "too few looks" : "hits and misses do not serve");
      continue;
    }
    out += formatted(
        "{:<14} {:>10} {:>6}  {:<26} {:<26} {:<20} {:>9.2f} mm  {:.2f}\n", name_of(pod.kind),
        pod.looked_for, pod.found, mm_words(pod.fit->x0), mm_words(pod.fit->a90),
        formatted("{:.2f} ({:.2f} to {:.2f})", pod.fit->b.value, pod.fit->b.low, pod.fit->b.high),
        1e3 * pod.at_detail_m, false_alarms_per_100_m2(pod));
  }
  return out;
}

json json_of(const KindScore& kind) {
  json ap;
  if (kind.average_precision)
    ap = {{"value", kind.average_precision->share},
          {"interval_95", {kind.average_precision->low, kind.average_precision->high}}};
  return {{"of", kind.of},
          {"labels", kind.labels},
          {"found", kind.found},
          {"ap50", ap},
          {"recall", share_or_null(kind.recall)},
          {"precision", share_or_null(kind.precision)},
          {"false_alarms_per_100_empty_pictures", share_or_null(kind.false_alarms_per_100)}};
}

json json_of(const BandScore& band) {
  json kinds = json::array();
  for (const KindScore& kind : band.kinds) kinds.push_back(json_of(kind));
  return {{"by", band.by},
          {"from", band.from},
          {"to", band.to},
          {"pictures", band.pictures},
          {"kinds", kinds}};
}

json json_of(const MeasuredPod& pod) {
  json out = {{"kind", name_of(pod.kind)},
              {"looked_for", pod.looked_for},
              {"not_seen", pod.not_seen},
              {"found", pod.found},
              {"at_detail_m", pod.at_detail_m},
              {"x0_m", json()},
              {"b", json()},
              {"a90_m", json()},
              {"false_alarms_per_100_m2", false_alarms_per_100_m2(pod)},
              {"size_error", {{"relative_sd", pod.size_sd}, {"relative_bias", pod.size_bias}}}};
  if (!pod.fit) return out;
  out["x0_m"] = within_json(pod.fit->x0);
  out["b"] = within_json(pod.fit->b);
  out["a90_m"] = within_json(pod.fit->a90);
  return out;
}

}  // namespace slackwater::api
