#include "api/perception/score_by_band.h"

#include <algorithm>
#include <numeric>

namespace slackwater::api {
namespace {

constexpr std::size_t bands = 3, least_pictures = 30;

void add_bands(const std::string& by, double LookFacts::*value, const DetectorScore& score,
               const LabelledPictures& set, std::vector<BandScore>& out) {
  std::vector<std::size_t> order(set.pictures.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto value_of = [&](std::size_t i) { return *set.pictures[i].look.*value; };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return value_of(a) < value_of(b); });
  for (std::size_t band = 0; band < bands; ++band) {
    const std::size_t from = order.size() * band / bands, to = order.size() * (band + 1) / bands;
    BandScore one{by, value_of(order[from]), value_of(order[to - 1]), to - from, {}};
    std::vector<ScoredPicture> pictures;
    for (std::size_t i = from; i < to; ++i) pictures.push_back(score.pictures[order[i]]);
    for (const KindScore& kind : score.kinds) one.kinds.push_back(score_of_kind(pictures, kind.of));
    out.push_back(std::move(one));
  }
}

}  // namespace

std::vector<BandScore> score_by_band(const DetectorScore& score, const LabelledPictures& set) {
  const bool is_staged =
      std::all_of(set.pictures.begin(), set.pictures.end(),
                  [](const LabelledPicture& one) { return one.look.has_value(); });
  std::vector<BandScore> out;
  if (!is_staged || set.pictures.size() < least_pictures) return out;
  add_bands("range_m", &LookFacts::range_m, score, set, out);
  add_bands("visibility_m", &LookFacts::visibility_m, score, set, out);
  return out;
}

}  // namespace slackwater::api
