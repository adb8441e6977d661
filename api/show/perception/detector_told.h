#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "api/perception/measured_pod.h"
#include "api/perception/score_by_band.h"

namespace slackwater::api {

/// How well a detector did, as a table for people: a line a kind, then what was not compared.
[[nodiscard]] std::string words_of(const DetectorScore& score);
/// By range and visibility: a line a third and kind. Empty of none.
[[nodiscard]] std::string words_of(const std::vector<BandScore>& bands);
/// The curves: a line a kind, with the ranges of 95 of 100 such trials.
[[nodiscard]] std::string words_of(const std::vector<MeasuredPod>& pods);

[[nodiscard]] nlohmann::json json_of(const KindScore& kind);
[[nodiscard]] nlohmann::json json_of(const BandScore& band);
[[nodiscard]] nlohmann::json json_of(const MeasuredPod& pod);

}  // namespace slackwater::api
