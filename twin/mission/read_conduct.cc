#include "twin/mission/conduct.h"
#include "twin/mission/reach.h"
#include "twin/mission/read_lookout.h"
#include "twin/mission/read_seconds.h"

namespace slackwater::twin {
namespace {

Triple<double> read_home(const Config& config) {
  const auto deep = config.optional_number("depth_m", reached_depth_m);
  const auto high = config.optional_number("height_m", reached_height_m);
  if (deep.has_value() == high.has_value())
    config.refuse("depth_m", "give one of depth_m and height_m");
  return {config.number("north_m", within_reach_m), config.number("east_m", within_reach_m),
          deep ? *deep : -*high};
}

Autonomy read_autonomy(const Config& config) {
  const std::string word = config.optional_text("autonomy").value_or("auto");
  for (const Autonomy autonomy : {Autonomy::automatic, Autonomy::shared, Autonomy::teleop})
    if (word == name_of(autonomy)) return autonomy;
  config.refuse("autonomy", "found " + word + ", expected auto, shared or teleop");
}

void read_pilot(const Config& config, Conduct& conduct) {
  const auto pilot = config.optional_child("pilot");
  if (!pilot) return;
  if (conduct.autonomy == Autonomy::automatic)
    config.refuse("pilot",
                  "found beside autonomy: auto, which has no pilot; write shared or teleop");
  PilotHand& hand = conduct.pilot;
  hand.wander_m = pilot->optional_number("wander_m", {0, 50}).value_or(hand.wander_m);
  hand.memory_s = pilot->optional_number("memory_s", {0.1, 600}).value_or(hand.memory_s);
  hand.haste = pilot->optional_number("haste", {0.1, 10}).value_or(hand.haste);
}

void read_envelope(const Config& config, Conduct& conduct) {
  const auto envelope = config.optional_child("envelope");
  if (!envelope) return;
  if (conduct.autonomy != Autonomy::shared)
    config.refuse(
        "envelope",
        "found without autonomy: shared; only shared autonomy keeps the pilot inside an envelope");
  conduct.envelope.most_speed_m_s =
      envelope->optional_number("most_speed_m_s", {0.01, 60}).value_or(0);
  conduct.envelope.stand_off_m = envelope->optional_number("stand_off_m", {0, 1000}).value_or(0);
  conduct.envelope.fence_m = envelope->optional_number("fence_m", {1, 50e3});
}

void read_mammals(const Config& config, Conduct& conduct) {
  const auto noisy = config.optional_text("noise_by");
  const auto mammals = config.optional_child("mammals");
  if (noisy && !mammals)
    config.refuse("noise_by", "found without mammals; it says whose noise that watch stops");
  if (!mammals) return;
  conduct.mammals = read_mammal_duty(*mammals);
  conduct.mammals->noise_by = noisy.value_or("");
  // Without a vehicle that makes it nobody knows how long the noise lasts.
  if (!noisy) (void)read_seconds(*mammals, "noise_for", {0, 86400});
}

}  // namespace

const char* name_of(Autonomy autonomy) noexcept {
  switch (autonomy) {
    case Autonomy::automatic:
      return "auto";
    case Autonomy::shared:
      return "shared";
    case Autonomy::teleop:
      return "teleop";
  }
  return "unknown";
}

Conduct read_conduct(const Config& config) {
  Conduct conduct;
  conduct.autonomy = read_autonomy(config);
  conduct.tick_s = config.optional_number("tick_s", {0.01, 60}).value_or(conduct.tick_s);
  if (const auto home = config.optional_child("home")) conduct.home_m = read_home(*home);
  conduct.clear_m = config.optional_number("clear_m", {0, 500}).value_or(conduct.clear_m);
  if (const auto reserve = config.optional_child("reserve")) {
    Reserve& r = conduct.reserve;
    r.share = reserve->optional_number("share", {0, 0.95}).value_or(r.share);
    r.margin = reserve->optional_number("margin", {1, 10}).value_or(r.margin);
  }
  if (const auto holding = config.optional_child("holding")) {
    Holding& h = conduct.holding;
    if (has_seconds(*holding, "resume_after"))
      h.resume_after_s = read_seconds(*holding, "resume_after", {0, 86400});
    h.overlap_m = holding->optional_number("overlap_m", {0, 1000}).value_or(h.overlap_m);
  }
  read_pilot(config, conduct);
  read_envelope(config, conduct);
  if (const auto point = config.optional_child("deck_point")) {
    constexpr Range on_board{-200, 200};
    conduct.deck_point_m = {point->number("forward_m", on_board),
                            point->optional_number("starboard_m", on_board).value_or(0),
                            -point->optional_number("up_m", on_board).value_or(0)};
  }
  conduct.limits = read_limits(config);
  conduct.faults = read_faults(config);
  conduct.assumed = read_assumptions(config);
  if (const auto search = config.optional_child("search"))
    conduct.search = read_person_search(*search);
  read_mammals(config, conduct);
  if (const auto cleaning = config.optional_child("cleaning"))
    conduct.cleaning = read_cleaning(*cleaning);
  if (const auto inspection = config.optional_child("inspection"))
    conduct.inspection = read_inspection(*inspection);
  if (config.has("behaviour"))
    conduct.behaviour = read_behaviour_tree(config, conduct_leaves());
  else if (config.has("trees"))
    config.refuse("trees",
                  "found without a behaviour that uses them; add behaviour, or leave trees out");
  return conduct;
}

}  // namespace slackwater::twin
