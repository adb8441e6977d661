#include "api/perception/measured_pod.h"

#include <algorithm>
#include <cmath>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/inspection/defect/defect_kind.h"

namespace slackwater::api {
namespace {

bool holds(const PixelBox& box, double u, double v) {
  return u >= box.left && u <= box.right && v >= box.top && v <= box.bottom;
}

/// A planted defect and what was found of it.
struct Search {
  double size_m = 0;
  double detail_m = 0;
  bool is_found = false;
};

class OfOneKind {
 public:
  explicit OfOneKind(twin::DefectKind kind) : kind_(kind), name_(twin::name_of(kind)) {
    pod_.kind = kind;
  }

  void add(const LookFacts& look, const ScoredPicture& picture) {
    pod_.read_m2 += look.seen_m2;
    for (std::size_t i = 0; i < look.planted.size(); ++i)
      if (look.planted[i].of == name_) add(look.planted[i], i, picture);
    for (const Detection& find : picture.found)
      if (find.of == name_ && is_false_alarm(find, picture)) ++pod_.false_alarms;
  }

  [[nodiscard]] MeasuredPod measured() {
    std::vector<double> details;
    for (const Search& search : searches_) details.push_back(search.detail_m);
    if (!details.empty()) {
      const auto tenth = details.begin() + static_cast<std::ptrdiff_t>(details.size() / 10);
      std::nth_element(details.begin(), tenth, details.end());
      pod_.at_detail_m = *tenth;
    }
    std::vector<twin::HitMiss> looks;
    for (const Search& search : searches_)
      looks.push_back(
          {search.size_m * std::min(1.0, pod_.at_detail_m / search.detail_m), search.is_found});
    pod_.looked_for = searches_.size();
    pod_.fit = twin::fit_hit_miss(looks);
    add_size_error();
    return pod_;
  }

 private:
  void add(const PlantedInLook& planted, std::size_t place, const ScoredPicture& picture) {
    if (!std::isfinite(planted.detail_m)) {
      ++pod_.not_seen;
      return;
    }
    Search search{planted.size_m, planted.detail_m, false};
    const auto label = std::find_if(picture.labels.begin(), picture.labels.end(),
                                    [&](const Label& one) { return one.planted == place; });
    const auto find =
        label == picture.labels.end()
            ? picture.found.end()
            : std::find_if(picture.found.begin(), picture.found.end(), [&](const Detection& one) {
                return one.of == name_ && holds(one.box, planted.u, planted.v) &&
                       overlap(one.box, label->box) >= least_shared_to_be_found;
              });
    if (find != picture.found.end()) {
      search.is_found = true;
      ++pod_.found;
      size_errors_.push_back(size_error(find->box, planted));
    }
    searches_.push_back(search);
  }

  [[nodiscard]] double size_error(const PixelBox& box, const PlantedInLook& planted) const {
    const double wide = box.right - box.left, high = box.bottom - box.top;
    const double side =
        kind_ == twin::DefectKind::crack ? std::hypot(wide, high) : std::max(wide, high);
    return side * planted.ground_sampling_m / planted.size_m - 1;
  }

  [[nodiscard]] bool is_false_alarm(const Detection& find, const ScoredPicture& picture) const {
    return std::none_of(picture.labels.begin(), picture.labels.end(), [&](const Label& label) {
      if (label.of != name_) return false;
      return overlap(find.box, label.box) >= least_shared_to_be_found ||
             (label.is_crowd && holds(find.box, 0.5 * (label.box.left + label.box.right),
                                      0.5 * (label.box.top + label.box.bottom)));
    });
  }

  void add_size_error() {
    const auto many = static_cast<double>(size_errors_.size());
    if (size_errors_.size() < 2) return;
    double sum = 0, squares = 0;
    for (const double error : size_errors_) sum += error;
    pod_.size_bias = sum / many;
    for (const double error : size_errors_) squares += std::pow(error - pod_.size_bias, 2);
    pod_.size_sd = std::sqrt(squares / (many - 1));
  }

  twin::DefectKind kind_;
  std::string name_;
  MeasuredPod pod_;
  std::vector<Search> searches_;
  std::vector<double> size_errors_;
};

}  // namespace

double false_alarms_per_100_m2(const MeasuredPod& pod) noexcept {
  return pod.read_m2 > 0 ? 100 * static_cast<double>(pod.false_alarms) / pod.read_m2 : 0;
}

std::vector<MeasuredPod> measure_pod(const DetectorScore& score, const LabelledPictures& set) {
  std::vector<MeasuredPod> out;
  for (const KindScore& scored : score.kinds) {
    const auto kind = twin::defect_kind_named(scored.of);
    if (!kind) continue;
    OfOneKind of(*kind);
    for (std::size_t i = 0; i < set.pictures.size(); ++i) {
      const LabelledPicture& picture = set.pictures[i];
      if (!picture.look)
        refuse("found " + picture.file.string() +
               " without its look, expected pictures of `slackwater stage`: only there is known "
               "what was planted and not seen");
      of.add(*picture.look, score.pictures[i]);
    }
    out.push_back(of.measured());
  }
  return out;
}

}  // namespace slackwater::api
