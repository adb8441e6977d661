#pragma once
#include <string>

#include "data/bag/channel.h"

namespace slackwater::bag {

/// A quality as rosbag2 writes it into "offered_qos_profiles": a YAML list of one profile, with the
/// numbers of rmw (as up to Iron; later versions read them too). What `Quality` does not say is
/// rmw's default: no deadline, no lifespan, automatic liveliness.
[[nodiscard]] std::string yaml_of(const Quality& quality);

/// The first profile of such a list, with numbers or with names. What is not there, or makes no
/// sense, is the default: nothing of what is read depends on it.
[[nodiscard]] Quality quality_of(const std::string& yaml);

}  // namespace slackwater::bag
