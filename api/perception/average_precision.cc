#include "api/perception/average_precision.h"

#include <algorithm>
#include <cmath>

#include "fields/base/numbers/random.h"

namespace slackwater::api {
namespace {

constexpr std::size_t most_finds = 100;  // of a picture, as COCO
constexpr int drawings = 1000;

/// A find that counts.
struct Judged {
  double confidence = 0;
  std::size_t picture = 0;
  bool is_right = false;
  bool is_told = true;
};

struct JudgedSet {
  std::vector<Judged> finds;        ///< surest first, of equal ones in the pictures' order
  std::vector<std::size_t> labels;  ///< of each picture
};

/// Of the find's area, what the crowd covers.
double share_in(const PixelBox& find, const PixelBox& crowd) noexcept {
  const PixelBox common{std::max(find.left, crowd.left), std::max(find.top, crowd.top),
                        std::min(find.right, crowd.right), std::min(find.bottom, crowd.bottom)};
  return common.right > common.left && common.bottom > common.top ? common.area() / find.area() : 0;
}

struct Find {
  const Detection* what;
  bool is_told;
};

/// The finds of one kind in a picture, surest first.
std::vector<Find> finds_of(const ScoredPicture& picture, const std::string& kind) {
  std::vector<Find> finds;
  for (const Detection& find : picture.found)
    if (find.of == kind) finds.push_back({&find, true});
  for (const Detection& find : picture.unsure)
    if (find.of == kind) finds.push_back({&find, false});
  std::stable_sort(finds.begin(), finds.end(), [](const Find& a, const Find& b) {
    return a.what->confidence > b.what->confidence;
  });
  if (finds.size() > most_finds) finds.resize(most_finds);
  return finds;
}

void judge(const ScoredPicture& picture, std::size_t nth, const std::string& kind,
           double least_overlap, JudgedSet& set) {
  std::vector<const Label*> labels, crowds;
  for (const Label& label : picture.labels)
    if (label.of == kind) (label.is_crowd ? crowds : labels).push_back(&label);
  std::vector<bool> is_taken(labels.size());
  for (const auto [find, is_told] : finds_of(picture, kind)) {
    std::optional<std::size_t> best;
    double most = least_overlap;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const double shared = is_taken[i] ? -1 : overlap(find->box, labels[i]->box);
      if (shared < most) continue;
      most = shared;
      best = i;
    }
    if (best) is_taken[*best] = true;
    const bool is_of_crowd =
        !best && std::any_of(crowds.begin(), crowds.end(), [&, what = find](const Label* crowd) {
          return share_in(what->box, crowd->box) >= least_overlap;
        });
    if (is_of_crowd) continue;
    set.finds.push_back({find->confidence, nth, best.has_value(), is_told});
  }
  set.labels.push_back(labels.size());
}

/// AP where each picture counts so many times.
/// @param times  of each picture
double precision_of(const JudgedSet& set, const std::vector<int>& times) {
  double labels = 0;
  for (std::size_t i = 0; i < times.size(); ++i)
    labels += static_cast<double>(set.labels[i]) * times[i];
  if (labels == 0) return std::nan("");
  std::vector<double> recall, precision;
  double right = 0, all = 0;
  for (const Judged& find : set.finds) {
    // As often as it is drawn; equal copies come in a row, as a stable sort has them.
    for (int i = 0; i < times[find.picture]; ++i) {
      ++all;
      right += find.is_right ? 1 : 0;
      recall.push_back(right / labels);
      precision.push_back(right / all);
    }
  }
  for (std::size_t i = precision.size(); i > 1; --i)
    precision[i - 2] = std::max(precision[i - 2], precision[i - 1]);
  double sum = 0;
  for (int i = 0; i <= 100; ++i) {
    const auto at = std::lower_bound(recall.begin(), recall.end(), i * 0.01);
    if (at != recall.end()) sum += precision[static_cast<std::size_t>(at - recall.begin())];
  }
  return sum / 101;
}

ShareWithin with_range(const JudgedSet& set, std::uint64_t seed) {
  const std::size_t pictures = set.labels.size();
  const double of_all = precision_of(set, std::vector<int>(pictures, 1));
  Rng rng(seed, "perception/pictures");
  std::vector<double> drawn;
  std::vector<int> times(pictures);
  for (int i = 0; i < drawings; ++i) {
    std::fill(times.begin(), times.end(), 0);
    for (std::size_t k = 0; k < pictures; ++k)
      ++times[static_cast<std::size_t>(rng.uniform() * static_cast<double>(pictures))];
    // A drawing without a label has no AP; the others stand for it.
    if (const double of_drawing = precision_of(set, times); !std::isnan(of_drawing))
      drawn.push_back(of_drawing);
  }
  if (drawn.empty()) return {of_all, 0, 1};
  std::sort(drawn.begin(), drawn.end());
  const auto at = [&](double share) {
    return drawn[static_cast<std::size_t>(share * static_cast<double>(drawn.size() - 1))];
  };
  return {of_all, at(0.025), at(0.975)};
}

}  // namespace

KindScore score_of_kind(std::span<const ScoredPicture> pictures, const std::string& kind,
                        double least_overlap, std::uint64_t seed) {
  JudgedSet set;
  for (std::size_t i = 0; i < pictures.size(); ++i) judge(pictures[i], i, kind, least_overlap, set);
  std::stable_sort(set.finds.begin(), set.finds.end(),
                   [](const Judged& a, const Judged& b) { return a.confidence > b.confidence; });
  KindScore score;
  score.of = kind;
  for (const std::size_t of_picture : set.labels) score.labels += of_picture;
  double right = 0;
  for (const Judged& find : set.finds) {
    score.found += find.is_told ? 1 : 0;
    right += find.is_told && find.is_right ? 1 : 0;
  }
  if (score.labels > 0) {
    score.average_precision = with_range(set, seed);
    score.recall = right / static_cast<double>(score.labels);
  }
  if (score.found > 0) score.precision = right / static_cast<double>(score.found);
  double without = 0, alarms = 0;
  for (const ScoredPicture& picture : pictures) {
    if (!picture.labels.empty()) continue;
    ++without;
    for (const Find& find : finds_of(picture, kind)) alarms += find.is_told ? 1 : 0;
  }
  if (without > 0) score.false_alarms_per_100 = 100 * alarms / without;
  return score;
}

}  // namespace slackwater::api
