#pragma once
#include <concepts>
#include <type_traits>

#include "twin/agent/agent.h"
#include "twin/mission/tick.h"
#include "twin/run/traffic_watch.h"

namespace slackwater::twin {

// The members of all that changes in a run by name, for what stores it and takes it up again. Each
// list is a structured binding of the whole struct: a member that is added and not named here does
// not compile.

/// Structs of doubles only, stored as a block of them.
template <typename T>
inline constexpr bool is_numbers = false;
template <>
inline constexpr bool is_numbers<VehicleState<double>> = true;
template <>
inline constexpr bool is_numbers<ControlState> = true;
template <>
inline constexpr bool is_numbers<DrydenFilter::State> = true;
template <>
inline constexpr bool is_numbers<TetherState<double>> = true;
template <>
inline constexpr bool is_numbers<LineTop> = true;
template <>
inline constexpr bool is_numbers<LinesBorne> = true;
template <>
inline constexpr bool is_numbers<FollowerState> = true;
template <>
inline constexpr bool is_numbers<NavigatorState> = true;
template <>
inline constexpr bool is_numbers<Shown> = true;
template <>
inline constexpr bool is_numbers<HeadwayState> = true;
template <>
inline constexpr bool is_numbers<ClearanceState> = true;
template <>
inline constexpr bool is_numbers<NearestPasses> = true;
template <>
inline constexpr bool is_numbers<CoarseState> = true;
template <>
inline constexpr bool is_numbers<Milestones> = true;
template <>
inline constexpr bool is_numbers<ThrustUse> = true;
template <>
inline constexpr bool is_numbers<BestLook> = true;
template <>
inline constexpr bool is_numbers<Pose> = true;
template <>
inline constexpr bool is_numbers<Spent> = true;
template <>
inline constexpr bool is_numbers<DeckMotion> = true;
template <>
inline constexpr bool is_numbers<Triple<double>> = true;
template <>
inline constexpr bool is_numbers<Attitude<double>> = true;
template <>
inline constexpr bool is_numbers<Course> = true;
template <>
inline constexpr bool is_numbers<Waypoint> = true;
template <>
inline constexpr bool is_numbers<Drifter> = true;
template <>
inline constexpr bool is_numbers<Mammal> = true;
template <>
inline constexpr bool is_numbers<DatumState> = true;
template <>
inline constexpr bool is_numbers<HelmVelocity> = true;
template <>
inline constexpr bool is_numbers<CameraPointing> = true;
template <>
inline constexpr bool is_numbers<ActuatorValues> = true;
template <>
inline constexpr bool is_numbers<ManoeuvreState> = true;
template <>
inline constexpr bool is_numbers<TaskOrder> = true;

template <typename S, typename T>
concept MaybeConst = std::same_as<std::remove_const_t<S>, T>;

template <MaybeConst<AgentState> S, typename Visit>
void for_each_member(S& s, Visit&& visit) {
  auto& [vehicle, control, mission, gust, gust_rng, tether, top, borne, navigation, headway,
         conduct, helm, clearance, nearest, coarse, milestones, thrust, inspection, halt,
         halted_at_s, water_m_s, wind_m_s, elevation_m, tether_n, is_retired, is_hosted] = s;
  visit("vehicle", vehicle);
  visit("control", control);
  visit("mission", mission);
  visit("gust", gust);
  visit("gust_rng", gust_rng);
  visit("tether", tether);
  visit("top", top);
  visit("borne", borne);
  visit("navigation", navigation);
  visit("headway", headway);
  visit("conduct", conduct);
  visit("helm", helm);
  visit("clearance", clearance);
  visit("nearest", nearest);
  visit("coarse", coarse);
  visit("milestones", milestones);
  visit("thrust", thrust);
  visit("inspection", inspection);
  visit("halt", halt);
  visit("halted_at_s", halted_at_s);
  visit("water_m_s", water_m_s);
  visit("wind_m_s", wind_m_s);
  visit("elevation_m", elevation_m);
  visit("tether_n", tether_n);
  visit("is_retired", is_retired);
  visit("is_hosted", is_hosted);
}

template <MaybeConst<InspectionState> S, typename Visit>
void for_each_member(S& s, Visit&& visit) {
  auto& [lines, best, seed, rays, worked_s] = s;
  visit("lines", lines);
  visit("best", best);
  visit("seed", seed);
  visit("rays", rays);
  visit("worked_s", worked_s);
}

template <MaybeConst<InspectionState::Line> S, typename Visit>
void for_each_member(S& s, Visit&& visit) {
  auto& [pose, place_m, ahead, range_m, looked_s, looks, has_looked] = s;
  visit("pose", pose);
  visit("place_m", place_m);
  visit("ahead", ahead);
  visit("range_m", range_m);
  visit("looked_s", looked_s);
  visit("looks", looks);
  visit("has_looked", has_looked);
}

template <MaybeConst<HelmState> S, typename Visit>
void for_each_member(S& s, Visit&& visit) {
  auto& [mode, cause, since_s, renewed_s, velocity, by_hand, way, is_loop, rounds, heading, depth_m,
         start_m, camera] = s;
  visit("mode", mode);
  visit("cause", cause);
  visit("since_s", since_s);
  visit("renewed_s", renewed_s);
  visit("velocity", velocity);
  visit("by_hand", by_hand);
  visit("way", way);
  visit("is_loop", is_loop);
  visit("rounds", rounds);
  visit("heading", heading);
  visit("depth_m", depth_m);
  visit("start_m", start_m);
  visit("camera", camera);
}

template <MaybeConst<MissionState> S, typename Visit>
void for_each_member(S& s, Visit&& visit) {
  auto& [task, has_begun, is_done, held_s, row, kept_m, kept_heading, route, is_rerouted,
         waypoints_taken, follower, followed_yaw_rad, track_drift_m_s, offset_m, manoeuvre,
         orders] = s;
  visit("task", task);
  visit("has_begun", has_begun);
  visit("is_done", is_done);
  visit("held_s", held_s);
  visit("row", row);
  visit("kept_m", kept_m);
  visit("kept_heading", kept_heading);
  visit("route", route);
  visit("is_rerouted", is_rerouted);
  visit("waypoints_taken", waypoints_taken);
  visit("follower", follower);
  visit("followed_yaw_rad", followed_yaw_rad);
  visit("track_drift_m_s", track_drift_m_s);
  visit("offset_m", offset_m);
  visit("manoeuvre", manoeuvre);
  visit("orders", orders);
}

template <MaybeConst<ConductState> S, typename Visit>
void for_each_member(S& s, Visit&& visit) {
  auto& [tree, doing, way, left_m, phase, cause, cause_detail, cause_value, exceeded_s, faults,
         extra_power_w, drawn_j, worked_at, wound_rad, bearing_rad, deck, energy_left_j,
         energy_home_j, held_s, least_charge, most_share, boarding_m, snag_m, snag_node, aim_m,
         pilot_rng, at_end, has_ended, has_turned, is_snagged, waits_for_line, is_aboard, search,
         datum, frame_m_s, mammals, noisy, cleaning, events] = s;
  visit("tree", tree);
  visit("doing", doing);
  visit("way", way);
  visit("left_m", left_m);
  visit("phase", phase);
  visit("cause", cause);
  visit("cause_detail", cause_detail);
  visit("cause_value", cause_value);
  visit("exceeded_s", exceeded_s);
  visit("faults", faults);
  visit("extra_power_w", extra_power_w);
  visit("drawn_j", drawn_j);
  visit("worked_at", worked_at);
  visit("wound_rad", wound_rad);
  visit("bearing_rad", bearing_rad);
  visit("deck", deck);
  visit("energy_left_j", energy_left_j);
  visit("energy_home_j", energy_home_j);
  visit("held_s", held_s);
  visit("least_charge", least_charge);
  visit("most_share", most_share);
  visit("boarding_m", boarding_m);
  visit("snag_m", snag_m);
  visit("snag_node", snag_node);
  visit("aim_m", aim_m);
  visit("pilot_rng", pilot_rng);
  visit("at_end", at_end);
  visit("has_ended", has_ended);
  visit("has_turned", has_turned);
  visit("is_snagged", is_snagged);
  visit("waits_for_line", waits_for_line);
  visit("is_aboard", is_aboard);
  visit("search", search);
  visit("datum", datum);
  visit("frame_m_s", frame_m_s);
  visit("mammals", mammals);
  visit("noisy", noisy);
  visit("cleaning", cleaning);
  visit("events", events);
}

template <MaybeConst<SearchState> S, typename Visit>
void for_each_member(S& s, Visit&& visit) {
  auto& [drifter, person, eyes_rng, off_m, is_looking, is_lost, is_found, found_s, found_at_m] = s;
  visit("drifter", drifter);
  visit("person", person);
  visit("eyes_rng", eyes_rng);
  visit("off_m", off_m);
  visit("is_looking", is_looking);
  visit("is_lost", is_lost);
  visit("is_found", is_found);
  visit("found_s", found_s);
  visit("found_at_m", found_at_m);
}

template <MaybeConst<MammalDutyState> S, typename Visit>
void for_each_member(S& s, Visit&& visit) {
  auto& [mammals, watch_rng, noise_m, sightings_s, watched_s, inside_s, until_s] = s;
  visit("mammals", mammals);
  visit("watch_rng", watch_rng);
  visit("noise_m", noise_m);
  visit("sightings_s", sightings_s);
  visit("watched_s", watched_s);
  visit("inside_s", inside_s);
  visit("until_s", until_s);
}

template <MaybeConst<NoisyWorkState> S, typename Visit>
void for_each_member(S& s, Visit&& visit) {
  auto& [clear_since_s, noisy_s, stops, is_clear, is_seen] = s;
  visit("clear_since_s", clear_since_s);
  visit("noisy_s", noisy_s);
  visit("stops", stops);
  visit("is_clear", is_clear);
  visit("is_seen", is_seen);
}

template <MaybeConst<CleaningState> S, typename Visit>
void for_each_member(S& s, Visit&& visit) {
  auto& [patches, along_m, down_m, worked_s, patch, is_on] = s;
  visit("patches", patches);
  visit("along_m", along_m);
  visit("down_m", down_m);
  visit("worked_s", worked_s);
  visit("patch", patch);
  visit("is_on", is_on);
}

template <MaybeConst<PatchState> S, typename Visit>
void for_each_member(S& s, Visit&& visit) {
  auto& [growth_nm, removed_nm] = s;
  visit("growth_nm", growth_nm);
  visit("removed_nm", removed_nm);
}

template <MaybeConst<MammalsState> S, typename Visit>
void for_each_member(S& s, Visit&& visit) {
  auto& [animals, rng] = s;
  visit("animals", animals);
  visit("rng", rng);
}

template <MaybeConst<DrifterState> S, typename Visit>
void for_each_member(S& s, Visit&& visit) {
  auto& [position_m, is_left, rng] = s;
  visit("position_m", position_m);
  visit("is_left", is_left);
  visit("rng", rng);
}

template <MaybeConst<ConductEvent> S, typename Visit>
void for_each_member(S& s, Visit&& visit) {
  auto& [t_s, kind, cause, detail, value] = s;
  visit("t_s", t_s);
  visit("kind", kind);
  visit("cause", cause);
  visit("detail", detail);
  visit("value", value);
}

template <MaybeConst<NavigationState> S, typename Visit>
void for_each_member(S& s, Visit&& visit) {
  auto& [instruments, navigator, error_m] = s;
  visit("instruments", instruments);
  visit("navigator", navigator);
  visit("error_m", error_m);
}

template <MaybeConst<InstrumentState> S, typename Visit>
void for_each_member(S& s, Visit&& visit) {
  auto& [imu, gnss, depth, compass, dvl, steps, velocity_before_m_s, attitude_before, shown] = s;
  visit("imu", imu);
  visit("gnss", gnss);
  visit("depth", depth);
  visit("compass", compass);
  visit("dvl", dvl);
  visit("steps", steps);
  visit("velocity_before_m_s", velocity_before_m_s);
  visit("attitude_before", attitude_before);
  visit("shown", shown);
}

template <MaybeConst<ImuState> S, typename Visit>
void for_each_member(S& s, Visit&& visit) {
  auto& [noise, gyro_bias_rad_s, accelerometer_bias_m_s2] = s;
  visit("noise", noise);
  visit("gyro_bias_rad_s", gyro_bias_rad_s);
  visit("accelerometer_bias_m_s2", accelerometer_bias_m_s2);
}

template <MaybeConst<GnssState> S, typename Visit>
void for_each_member(S& s, Visit&& visit) {
  auto& [noise, slow_m, seen_s] = s;
  visit("noise", noise);
  visit("slow_m", slow_m);
  visit("seen_s", seen_s);
}

template <MaybeConst<TrafficWatch::State> S, typename Visit>
void for_each_member(S& s, Visit&& visit) {
  auto& [alarms, records] = s;
  visit("alarms", alarms);
  visit("records", records);
}

template <MaybeConst<Alarm> S, typename Visit>
void for_each_member(S& s, Visit&& visit) {
  auto& [id, status, approach] = s;
  visit("id", id);
  visit("status", status);
  visit("approach", approach);
}

template <MaybeConst<ClosestApproach> S, typename Visit>
void for_each_member(S& s, Visit&& visit) {
  auto& [time_s, distance_m, is_closing] = s;
  visit("time_s", time_s);
  visit("distance_m", distance_m);
  visit("is_closing", is_closing);
}

template <MaybeConst<AlarmRecord> S, typename Visit>
void for_each_member(S& s, Visit&& visit) {
  auto& [vehicle, mmsi, begin_s, end_s, end, cpa_m, tcpa_s, least_distance_m, least_distance_s] = s;
  visit("vehicle", vehicle);
  visit("mmsi", mmsi);
  visit("begin_s", begin_s);
  visit("end_s", end_s);
  visit("end", end);
  visit("cpa_m", cpa_m);
  visit("tcpa_s", tcpa_s);
  visit("least_distance_m", least_distance_m);
  visit("least_distance_s", least_distance_s);
}

template <MaybeConst<BehaviourState> S, typename Visit>
void for_each_member(S& s, Visit&& visit) {
  auto& [nodes] = s;
  visit("nodes", nodes);
}

template <MaybeConst<NodeState> S, typename Visit>
void for_each_member(S& s, Visit&& visit) {
  auto& [status, child, failures, began_s] = s;
  visit("status", status);
  visit("child", child);
  visit("failures", failures);
  visit("began_s", began_s);
}

template <typename S, typename Visit>
requires MaybeConst<S, Rng> || MaybeConst<S, NoiseStream> || MaybeConst<S, Route>
void for_each_member(S& s, Visit&& visit) {
  std::remove_const_t<S>::for_each_member(s, std::forward<Visit>(visit));
}

}  // namespace slackwater::twin
