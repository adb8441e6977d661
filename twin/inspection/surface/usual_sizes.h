#pragma once

// What is made (this folder) and where work is laid out (twin/mission) take the same sizes.

namespace slackwater::twin::usual {

// Sizes that a site does not state. "NREL": of the NREL offshore 5 MW turbine, Jonkman,
// Butterfield, Musial & Scott (2009), NREL/TP-500-38060; lengths of the rotor are scaled with its
// radius, 63 m there. All others are estimates of this program, of the order of what is built: a
// surface says its own where they are known.

inline constexpr double rotor_radius_m = 63;  ///< NREL, to which the following belong
inline constexpr double overhang_m = 5;  ///< of the rotor before the tower's axis; NREL, table 1-1
inline constexpr double blade_root_m = 4;          ///< where a blade begins; estimate
inline constexpr double blade_chord_m = 4.65;      ///< widest; NREL, table 3-1
inline constexpr double blade_tip_chord_m = 1.42;  ///< NREL, table 3-1
inline constexpr double blade_twist_deg = 13.3;    ///< at the root, 0 at the tip; NREL, table 3-1
inline constexpr double blade_root_thickness = 0.40;  ///< of the chord: DU 40; NREL, table 3-1
inline constexpr double blade_tip_thickness = 0.18;   ///< NACA 64-618; NREL, table 3-1
inline constexpr double blade_camber = 0.04;          ///< of the chord, at 0.4 of it; estimate

inline constexpr double tower_top_share = 0.645;  ///< of its foot: 3.87 m of 6 m; NREL, 6-1
inline constexpr double tower_below_hub_m = 2.4;  ///< its top: 87.6 m and 90 m; NREL, 6-1

inline constexpr double nacelle_length_m = 14;   ///< estimate, with the rotor's radius
inline constexpr double nacelle_width_m = 4.6;   ///< estimate, with the rotor's radius
inline constexpr double nacelle_height_m = 4.8;  ///< estimate, with the rotor's radius
inline constexpr double nacelle_ahead_m = 3.5;   ///< of its front before the tower's axis; estimate
inline constexpr double nacelle_roof_rise_m = 0.3;  ///< of the middle of its roof; estimate

inline constexpr double transition_wider_m = 0.2;     ///< its radius beyond the pile's; estimate
inline constexpr double transition_foot_depth_m = 3;  ///< its lower edge; estimate
inline constexpr double flange_width_m = 0.15;        ///< beyond the radius; estimate
inline constexpr double flange_thickness_m = 0.1;     ///< estimate
inline constexpr int bolts = 100;                     ///< round the flange; estimate
inline constexpr double bolt_m = 0.08;                ///< across a head: of an M48 to M56; estimate
inline constexpr double bolt_height_m = 0.12;         ///< estimate
inline constexpr double fender_radius_m = 0.2;        ///< of boat landings, 400 mm tubes; estimate
inline constexpr double fender_spacing_m = 2;         ///< between the axes of both; estimate
inline constexpr double fender_off_m = 1;             ///< of their axes before the face; estimate
inline constexpr double ladder_off_m = 0.5;           ///< of its stiles before the face; estimate
inline constexpr double ladder_width_m = 0.5;         ///< between stiles; estimate
inline constexpr double rung_spacing_m = 0.3;         ///< ISO 14122-4 has 0.225 to 0.3; estimate
inline constexpr double rung_radius_m = 0.02;         ///< estimate

inline constexpr double anode_length_m = 1.5;  ///< stand-off anodes of aluminium; estimate
inline constexpr double anode_width_m = 0.25;  ///< estimate
inline constexpr double anode_off_m = 0.3;     ///< of its middle before the pile; estimate
inline constexpr int anode_bars = 4;           ///< round the pile; estimate
inline constexpr int anode_rows = 3;           ///< estimate

inline constexpr double chain_radius_m = 0.25;  ///< of the tube about a chain; estimate
inline constexpr double cable_radius_m = 0.08;  ///< of an inter-array cable; estimate
inline constexpr double burial_m = 1;           ///< of its top; estimate
inline constexpr double corridor_m = 10;        ///< of bed above it; estimate
inline constexpr double off_ends_m = 40;        ///< of a cable, not up to its piles; estimate

inline constexpr double watch_radius_m =
    500;                                 ///< of water about a foundation: JNCC (2010), for piling
inline constexpr double bed_radii = 5;   ///< of the foundation, round it; estimate
inline constexpr double slope_deg = 32;  ///< of a scour pit: the angle of repose of sand; estimate

}  // namespace slackwater::twin::usual
