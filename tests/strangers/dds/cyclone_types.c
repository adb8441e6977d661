#include "cyclone_types.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

// What a field takes: see CountedValues of counted_values.h, which does the same in C++. Nothing is
// given back: the program ends soon.

static void real(unsigned* n, double* v) {
  const unsigned i = (*n)++;
  *v = (i % 2 == 1 ? -1 : 1) * (i + 0.25);
}
static void real32(unsigned* n, float* v) {
  double wide;
  real(n, &wide);
  *v = (float)wide;
}
static void uint32(unsigned* n, uint32_t* v) { *v = (*n)++ * 0x01020304U; }
static void int32(unsigned* n, int32_t* v) { *v = (int32_t)((*n)++ * 0x01020304U); }
static void uint16(unsigned* n, uint16_t* v) { *v = (uint16_t)((*n)++ * 257); }
static void int8(unsigned* n, int8_t* v) { *v = (int8_t)(*n)++; }
static void octet(unsigned* n, uint8_t* v) { *v = (uint8_t)(*n)++; }
static void character(unsigned* n, char* v) { *v = (char)(*n)++; }
static void boolean(unsigned* n, bool* v) { *v = (*n)++ % 2 == 1; }
static void short_text(unsigned* n, char* v) {
  const unsigned letters = (*n)++ % 9;
  memcpy(v, "abcdefgh", letters);
  v[letters] = 0;
}
static void text(unsigned* n, char** v) {
  *v = malloc(9);
  short_text(n, *v);
}
#define ARRAY(field, put)                                          \
  for (size_t i = 0; i < sizeof(field) / sizeof((field)[0]); ++i) \
  put(n, &(field)[i])
#define SEQUENCE(field, type, put)                            \
  do {                                                        \
    (field)._length = (field)._maximum = (*n)++ % 3;          \
    (field)._release = true;                                  \
    (field)._buffer = calloc((field)._length + 1, sizeof(type)); \
    for (uint32_t i = 0; i < (field)._length; ++i) put(n, &(field)._buffer[i]); \
  } while (0)

static void fill_builtin_interfaces_msg_Time(unsigned* n, builtin_interfaces_msg_Time* m) {
  int32(n, &m->sec);
  uint32(n, &m->nanosec);
}
static void fill_builtin_interfaces_msg_Duration(unsigned* n, builtin_interfaces_msg_Duration* m) {
  int32(n, &m->sec);
  uint32(n, &m->nanosec);
}
static void fill_std_msgs_msg_Header(unsigned* n, std_msgs_msg_Header* m) {
  fill_builtin_interfaces_msg_Time(n, &m->stamp);
  text(n, &m->frame_id);
}
static void fill_std_msgs_msg_String(unsigned* n, std_msgs_msg_String* m) {
  text(n, &m->data);
}
static void fill_std_msgs_msg_Float64(unsigned* n, std_msgs_msg_Float64* m) {
  real(n, &m->data);
}
static void fill_std_msgs_msg_MultiArrayDimension(unsigned* n, std_msgs_msg_MultiArrayDimension* m) {
  text(n, &m->label);
  uint32(n, &m->size);
  uint32(n, &m->stride);
}
static void fill_std_msgs_msg_MultiArrayLayout(unsigned* n, std_msgs_msg_MultiArrayLayout* m) {
  SEQUENCE(m->dim, struct std_msgs_msg_MultiArrayDimension, fill_std_msgs_msg_MultiArrayDimension);
  uint32(n, &m->data_offset);
}
static void fill_std_msgs_msg_Float64MultiArray(unsigned* n, std_msgs_msg_Float64MultiArray* m) {
  fill_std_msgs_msg_MultiArrayLayout(n, &m->layout);
  SEQUENCE(m->data, double, real);
}
static void fill_geometry_msgs_msg_Vector3(unsigned* n, geometry_msgs_msg_Vector3* m) {
  real(n, &m->x);
  real(n, &m->y);
  real(n, &m->z);
}
static void fill_geometry_msgs_msg_Vector3Stamped(unsigned* n, geometry_msgs_msg_Vector3Stamped* m) {
  fill_std_msgs_msg_Header(n, &m->header);
  fill_geometry_msgs_msg_Vector3(n, &m->vector);
}
static void fill_geometry_msgs_msg_Point(unsigned* n, geometry_msgs_msg_Point* m) {
  real(n, &m->x);
  real(n, &m->y);
  real(n, &m->z);
}
static void fill_geometry_msgs_msg_Quaternion(unsigned* n, geometry_msgs_msg_Quaternion* m) {
  real(n, &m->x);
  real(n, &m->y);
  real(n, &m->z);
  real(n, &m->w);
}
static void fill_geometry_msgs_msg_Pose(unsigned* n, geometry_msgs_msg_Pose* m) {
  fill_geometry_msgs_msg_Point(n, &m->position);
  fill_geometry_msgs_msg_Quaternion(n, &m->orientation);
}
static void fill_geometry_msgs_msg_PoseStamped(unsigned* n, geometry_msgs_msg_PoseStamped* m) {
  fill_std_msgs_msg_Header(n, &m->header);
  fill_geometry_msgs_msg_Pose(n, &m->pose);
}
static void fill_geometry_msgs_msg_PoseWithCovariance(unsigned* n, geometry_msgs_msg_PoseWithCovariance* m) {
  fill_geometry_msgs_msg_Pose(n, &m->pose);
  ARRAY(m->covariance, real);
}
static void fill_geometry_msgs_msg_Twist(unsigned* n, geometry_msgs_msg_Twist* m) {
  fill_geometry_msgs_msg_Vector3(n, &m->linear);
  fill_geometry_msgs_msg_Vector3(n, &m->angular);
}
static void fill_geometry_msgs_msg_TwistWithCovariance(unsigned* n, geometry_msgs_msg_TwistWithCovariance* m) {
  fill_geometry_msgs_msg_Twist(n, &m->twist);
  ARRAY(m->covariance, real);
}
static void fill_geometry_msgs_msg_TwistWithCovarianceStamped(unsigned* n, geometry_msgs_msg_TwistWithCovarianceStamped* m) {
  fill_std_msgs_msg_Header(n, &m->header);
  fill_geometry_msgs_msg_TwistWithCovariance(n, &m->twist);
}
static void fill_nav_msgs_msg_Odometry(unsigned* n, nav_msgs_msg_Odometry* m) {
  fill_std_msgs_msg_Header(n, &m->header);
  text(n, &m->child_frame_id);
  fill_geometry_msgs_msg_PoseWithCovariance(n, &m->pose);
  fill_geometry_msgs_msg_TwistWithCovariance(n, &m->twist);
}
static void fill_nav_msgs_msg_Path(unsigned* n, nav_msgs_msg_Path* m) {
  fill_std_msgs_msg_Header(n, &m->header);
  SEQUENCE(m->poses, struct geometry_msgs_msg_PoseStamped, fill_geometry_msgs_msg_PoseStamped);
}
static void fill_sensor_msgs_msg_BatteryState(unsigned* n, sensor_msgs_msg_BatteryState* m) {
  fill_std_msgs_msg_Header(n, &m->header);
  real32(n, &m->voltage);
  real32(n, &m->temperature);
  real32(n, &m->current);
  real32(n, &m->charge);
  real32(n, &m->capacity);
  real32(n, &m->design_capacity);
  real32(n, &m->percentage);
  octet(n, &m->power_supply_status);
  octet(n, &m->power_supply_health);
  octet(n, &m->power_supply_technology);
  boolean(n, &m->present);
  SEQUENCE(m->cell_voltage, float, real32);
  SEQUENCE(m->cell_temperature, float, real32);
  text(n, &m->location);
  text(n, &m->serial_number);
}
static void fill_sensor_msgs_msg_Imu(unsigned* n, sensor_msgs_msg_Imu* m) {
  fill_std_msgs_msg_Header(n, &m->header);
  fill_geometry_msgs_msg_Quaternion(n, &m->orientation);
  ARRAY(m->orientation_covariance, real);
  fill_geometry_msgs_msg_Vector3(n, &m->angular_velocity);
  ARRAY(m->angular_velocity_covariance, real);
  fill_geometry_msgs_msg_Vector3(n, &m->linear_acceleration);
  ARRAY(m->linear_acceleration_covariance, real);
}
static void fill_sensor_msgs_msg_NavSatStatus(unsigned* n, sensor_msgs_msg_NavSatStatus* m) {
  int8(n, &m->status);
  uint16(n, &m->service);
}
static void fill_sensor_msgs_msg_NavSatFix(unsigned* n, sensor_msgs_msg_NavSatFix* m) {
  fill_std_msgs_msg_Header(n, &m->header);
  fill_sensor_msgs_msg_NavSatStatus(n, &m->status);
  real(n, &m->latitude);
  real(n, &m->longitude);
  real(n, &m->altitude);
  ARRAY(m->position_covariance, real);
  octet(n, &m->position_covariance_type);
}
static void fill_sensor_msgs_msg_FluidPressure(unsigned* n, sensor_msgs_msg_FluidPressure* m) {
  fill_std_msgs_msg_Header(n, &m->header);
  real(n, &m->fluid_pressure);
  real(n, &m->variance);
}
static void fill_rosgraph_msgs_msg_Clock(unsigned* n, rosgraph_msgs_msg_Clock* m) {
  fill_builtin_interfaces_msg_Time(n, &m->clock);
}
static void fill_std_srvs_srv_Trigger_Request(unsigned* n, std_srvs_srv_Trigger_Request* m) {
  octet(n, &m->structure_needs_at_least_one_member);
}
static void fill_std_srvs_srv_Trigger_Response(unsigned* n, std_srvs_srv_Trigger_Response* m) {
  boolean(n, &m->success);
  text(n, &m->message);
}
static void fill_std_srvs_srv_SetBool_Request(unsigned* n, std_srvs_srv_SetBool_Request* m) {
  boolean(n, &m->data);
}
static void fill_std_srvs_srv_SetBool_Response(unsigned* n, std_srvs_srv_SetBool_Response* m) {
  boolean(n, &m->success);
  text(n, &m->message);
}
static void fill_rmw_dds_common_msg_Gid(unsigned* n, rmw_dds_common_msg_Gid* m) {
  ARRAY(m->data, character);
}
static void fill_rmw_dds_common_msg_NodeEntitiesInfo(unsigned* n, rmw_dds_common_msg_NodeEntitiesInfo* m) {
  short_text(n, m->node_namespace);
  short_text(n, m->node_name);
  SEQUENCE(m->reader_gid_seq, struct rmw_dds_common_msg_Gid, fill_rmw_dds_common_msg_Gid);
  SEQUENCE(m->writer_gid_seq, struct rmw_dds_common_msg_Gid, fill_rmw_dds_common_msg_Gid);
}
static void fill_rmw_dds_common_msg_ParticipantEntitiesInfo(unsigned* n, rmw_dds_common_msg_ParticipantEntitiesInfo* m) {
  fill_rmw_dds_common_msg_Gid(n, &m->gid);
  SEQUENCE(m->node_entities_info_seq, struct rmw_dds_common_msg_NodeEntitiesInfo, fill_rmw_dds_common_msg_NodeEntitiesInfo);
}
static void fill_unique_identifier_msgs_msg_UUID(unsigned* n, unique_identifier_msgs_msg_UUID* m) {
  ARRAY(m->uuid, octet);
}
static void fill_action_msgs_msg_GoalInfo(unsigned* n, action_msgs_msg_GoalInfo* m) {
  fill_unique_identifier_msgs_msg_UUID(n, &m->goal_id);
  fill_builtin_interfaces_msg_Time(n, &m->stamp);
}
static void fill_action_msgs_msg_GoalStatus(unsigned* n, action_msgs_msg_GoalStatus* m) {
  fill_action_msgs_msg_GoalInfo(n, &m->goal_info);
  int8(n, &m->status);
}
static void fill_action_msgs_msg_GoalStatusArray(unsigned* n, action_msgs_msg_GoalStatusArray* m) {
  SEQUENCE(m->status_list, struct action_msgs_msg_GoalStatus, fill_action_msgs_msg_GoalStatus);
}
static void fill_action_msgs_srv_CancelGoal_Request(unsigned* n, action_msgs_srv_CancelGoal_Request* m) {
  fill_action_msgs_msg_GoalInfo(n, &m->goal_info);
}
static void fill_action_msgs_srv_CancelGoal_Response(unsigned* n, action_msgs_srv_CancelGoal_Response* m) {
  int8(n, &m->return_code);
  SEQUENCE(m->goals_canceling, struct action_msgs_msg_GoalInfo, fill_action_msgs_msg_GoalInfo);
}
static void fill_slackwater_msgs_msg_Reserve(unsigned* n, slackwater_msgs_msg_Reserve* m) {
  fill_std_msgs_msg_Header(n, &m->header);
  real(n, &m->energy_left_j);
  real(n, &m->energy_home_j);
  real(n, &m->margin_s);
  text(n, &m->advice);
}
static void fill_slackwater_msgs_msg_CurrentProfile(unsigned* n, slackwater_msgs_msg_CurrentProfile* m) {
  fill_std_msgs_msg_Header(n, &m->header);
  text(n, &m->instance);
  real(n, &m->latitude);
  real(n, &m->longitude);
  SEQUENCE(m->depth_m, double, real);
  SEQUENCE(m->east_m_s, double, real);
  SEQUENCE(m->north_m_s, double, real);
  SEQUENCE(m->east_p10, double, real);
  SEQUENCE(m->east_p90, double, real);
  SEQUENCE(m->north_p10, double, real);
  SEQUENCE(m->north_p90, double, real);
}
static void fill_slackwater_msgs_msg_SeaState(unsigned* n, slackwater_msgs_msg_SeaState* m) {
  fill_std_msgs_msg_Header(n, &m->header);
  real(n, &m->hs_m);
  real(n, &m->tp_s);
  real(n, &m->from_deg);
}
static void fill_slackwater_msgs_msg_AisTarget(unsigned* n, slackwater_msgs_msg_AisTarget* m) {
  fill_std_msgs_msg_Header(n, &m->header);
  uint32(n, &m->mmsi);
  text(n, &m->name);
  real(n, &m->latitude);
  real(n, &m->longitude);
  real(n, &m->sog_m_s);
  real(n, &m->cog_deg);
  real(n, &m->cpa_m);
  real(n, &m->tcpa_s);
}
static void fill_slackwater_msgs_srv_Step_Request(unsigned* n, slackwater_msgs_srv_Step_Request* m) {
  uint32(n, &m->steps);
}
static void fill_slackwater_msgs_srv_Step_Response(unsigned* n, slackwater_msgs_srv_Step_Response* m) {
  boolean(n, &m->success);
}
static void fill_slackwater_msgs_srv_Spawn_Request(unsigned* n, slackwater_msgs_srv_Spawn_Request* m) {
  text(n, &m->model);
  text(n, &m->name);
  fill_geometry_msgs_msg_PoseStamped(n, &m->pose);
}
static void fill_slackwater_msgs_srv_Spawn_Response(unsigned* n, slackwater_msgs_srv_Spawn_Response* m) {
  boolean(n, &m->success);
  text(n, &m->message);
}
static void fill_slackwater_msgs_srv_SetWaypoints_Request(unsigned* n, slackwater_msgs_srv_SetWaypoints_Request* m) {
  fill_nav_msgs_msg_Path(n, &m->path);
  boolean(n, &m->loop);
}
static void fill_slackwater_msgs_srv_SetWaypoints_Response(unsigned* n, slackwater_msgs_srv_SetWaypoints_Response* m) {
  boolean(n, &m->success);
  text(n, &m->message);
}
static void fill_slackwater_msgs_srv_QueryProfile_Request(unsigned* n, slackwater_msgs_srv_QueryProfile_Request* m) {
  real(n, &m->latitude);
  real(n, &m->longitude);
  fill_builtin_interfaces_msg_Time(n, &m->time);
}
static void fill_slackwater_msgs_srv_QueryProfile_Response(unsigned* n, slackwater_msgs_srv_QueryProfile_Response* m) {
  boolean(n, &m->success);
  text(n, &m->message);
  fill_slackwater_msgs_msg_CurrentProfile(n, &m->profile);
}
static void fill_slackwater_msgs_action_Navigate_Goal(unsigned* n, slackwater_msgs_action_Navigate_Goal* m) {
  fill_nav_msgs_msg_Path(n, &m->path);
}
static void fill_slackwater_msgs_action_Navigate_Result(unsigned* n, slackwater_msgs_action_Navigate_Result* m) {
  boolean(n, &m->success);
  text(n, &m->message);
}
static void fill_slackwater_msgs_action_Navigate_Feedback(unsigned* n, slackwater_msgs_action_Navigate_Feedback* m) {
  uint32(n, &m->waypoint);
  real(n, &m->distance_m);
}
static void fill_slackwater_msgs_action_Navigate_SendGoal_Request(unsigned* n, slackwater_msgs_action_Navigate_SendGoal_Request* m) {
  fill_unique_identifier_msgs_msg_UUID(n, &m->goal_id);
  fill_slackwater_msgs_action_Navigate_Goal(n, &m->goal);
}
static void fill_slackwater_msgs_action_Navigate_SendGoal_Response(unsigned* n, slackwater_msgs_action_Navigate_SendGoal_Response* m) {
  boolean(n, &m->accepted);
  fill_builtin_interfaces_msg_Time(n, &m->stamp);
}
static void fill_slackwater_msgs_action_Navigate_GetResult_Request(unsigned* n, slackwater_msgs_action_Navigate_GetResult_Request* m) {
  fill_unique_identifier_msgs_msg_UUID(n, &m->goal_id);
}
static void fill_slackwater_msgs_action_Navigate_GetResult_Response(unsigned* n, slackwater_msgs_action_Navigate_GetResult_Response* m) {
  int8(n, &m->status);
  fill_slackwater_msgs_action_Navigate_Result(n, &m->result);
}
static void fill_slackwater_msgs_action_Navigate_FeedbackMessage(unsigned* n, slackwater_msgs_action_Navigate_FeedbackMessage* m) {
  fill_unique_identifier_msgs_msg_UUID(n, &m->goal_id);
  fill_slackwater_msgs_action_Navigate_Feedback(n, &m->feedback);
}

#define CASE(package, kind, name)                                             \
  {#package "/" #kind "/" #name, #package "::" #kind "::dds_::" #name "_",    \
   &package##_##kind##_##name##_desc,                                         \
   (void (*)(unsigned*, void*))(void (*)(void))fill_##package##_##kind##_##name},
const struct cyclone_type cyclone_types[] = {SLACKWATER_EVERY_TYPE(CASE){NULL, NULL, NULL, NULL}};

const struct cyclone_type* cyclone_type_named(const char* ros_name) {
  for (const struct cyclone_type* type = cyclone_types; type->ros_name != NULL; ++type)
    if (strcmp(type->ros_name, ros_name) == 0) return type;
  return NULL;
}

dds_entity_t topic_of(dds_entity_t participant, const struct cyclone_type* type,
                      const char* dds_topic) {
  dds_topic_descriptor_t named = *type->descriptor;
  // The field is const; a descriptor under another name is what is wanted.
  *(const char**)(void*)&named.m_typename = type->dds_name;
  return dds_create_topic(participant, &named, dds_topic, NULL, NULL);
}
