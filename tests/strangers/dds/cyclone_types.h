#pragma once
#include "action_msgs.h"
#include "dds/dds.h"
#include "every_type.h"
#include "marine_acoustic_msgs.h"
#include "nav_msgs.h"
#include "rcl_interfaces.h"
#include "rmw_dds_common.h"
#include "rosgraph_msgs.h"
#include "sensor_msgs.h"
#include "slackwater_msgs.h"
#include "std_srvs.h"
#include "vision_msgs.h"

// Every structure of api/door/dds/idl as idlc made it, under its name on ROS 2's wire.

struct cyclone_type {
  const char* ros_name;  ///< "nav_msgs/msg/Odometry"
  const char* dds_name;  ///< "nav_msgs::msg::dds_::Odometry_"
  const dds_topic_descriptor_t* descriptor;
  void (*fill)(unsigned* n, void* message);  ///< with counted values, from n on
};
/// Up to one without a name.
extern const struct cyclone_type cyclone_types[];

/// NULL where there is none.
const struct cyclone_type* cyclone_type_named(const char* ros_name);
/// A topic of that type by its name on the wire: names alone decide who matches.
dds_entity_t topic_of(dds_entity_t participant, const struct cyclone_type* type,
                      const char* dds_topic);
