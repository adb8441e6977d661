#include "cyclone_json.h"

#include <math.h>
#include <string.h>

static void number(FILE* out, double v) {
  if (isfinite(v))
    fprintf(out, "%.17g", v);
  else
    fputs("null", out);
}
static void numbers(FILE* out, const char* name, const double* v, size_t count, size_t stride) {
  fprintf(out, "\"%s\": [", name);
  for (size_t i = 0; i < count; ++i) {
    if (i > 0) fputs(", ", out);
    number(out, v[i * stride]);
  }
  fputs("]", out);
}
static void sequence(FILE* out, const char* name, const dds_sequence_double* v) {
  numbers(out, name, v->_buffer, v->_length, 1);
}
static void named(FILE* out, const char* name, double v) {
  fprintf(out, "\"%s\": ", name);
  number(out, v);
}
static void text(FILE* out, const char* name, const char* v) {
  fprintf(out, "\"%s\": \"", name);
  for (; *v != 0; ++v) {
    if (*v == '"' || *v == '\\') fputc('\\', out);
    if ((unsigned char)*v < 0x20)
      fprintf(out, "\\u%04x", *v);
    else
      fputc(*v, out);
  }
  fputs("\"", out);
}
static void comma(FILE* out) { fputs(", ", out); }

static void stamp(FILE* out, const char* name, const builtin_interfaces_msg_Time* v) {
  fprintf(out, "\"%s\": {\"sec\": %d, \"nanosec\": %u}", name, v->sec, v->nanosec);
}
static void header(FILE* out, const std_msgs_msg_Header* v) {
  fputs("\"header\": {", out);
  stamp(out, "stamp", &v->stamp);
  comma(out);
  text(out, "frame_id", v->frame_id);
  fputs("}", out);
}
static void pose(FILE* out, const geometry_msgs_msg_Pose* v) {
  numbers(out, "position", &v->position.x, 3, 1);
  comma(out);
  numbers(out, "orientation", &v->orientation.x, 4, 1);
}
static void twist(FILE* out, const geometry_msgs_msg_Twist* v) {
  numbers(out, "linear", &v->linear.x, 3, 1);
  comma(out);
  numbers(out, "angular", &v->angular.x, 3, 1);
}
static void id(FILE* out, const unique_identifier_msgs_msg_UUID* v) {
  fputs("\"goal_id\": \"", out);
  for (size_t i = 0; i < sizeof v->uuid; ++i) fprintf(out, "%02x", v->uuid[i]);
  fputs("\"", out);
}

static void clock_json(FILE* out, const rosgraph_msgs_msg_Clock* v) {
  stamp(out, "clock", &v->clock);
}
static void odometry(FILE* out, const nav_msgs_msg_Odometry* v) {
  header(out, &v->header);
  comma(out);
  text(out, "child_frame_id", v->child_frame_id);
  comma(out);
  pose(out, &v->pose.pose);
  comma(out);
  numbers(out, "pose_covariance", v->pose.covariance, 6, 7);
  comma(out);
  twist(out, &v->twist.twist);
  comma(out);
  numbers(out, "twist_covariance", v->twist.covariance, 6, 7);
}
static void pose_stamped(FILE* out, const geometry_msgs_msg_PoseStamped* v) {
  header(out, &v->header);
  comma(out);
  pose(out, &v->pose);
}
static void battery(FILE* out, const sensor_msgs_msg_BatteryState* v) {
  const struct {
    const char* name;
    float value;
  } fields[] = {{"voltage", v->voltage},      {"temperature", v->temperature},
                {"current", v->current},      {"charge", v->charge},
                {"capacity", v->capacity},    {"design_capacity", v->design_capacity},
                {"percentage", v->percentage}};
  header(out, &v->header);
  for (size_t i = 0; i < sizeof fields / sizeof fields[0]; ++i) {
    comma(out);
    named(out, fields[i].name, (double)fields[i].value);
  }
  fprintf(out,
          ", \"power_supply_status\": %u, \"power_supply_health\": %u, "
          "\"power_supply_technology\": %u, \"present\": %s, \"cells\": [%u, %u], ",
          v->power_supply_status, v->power_supply_health, v->power_supply_technology,
          v->present ? "true" : "false", v->cell_voltage._length, v->cell_temperature._length);
  text(out, "location", v->location);
  comma(out);
  text(out, "serial_number", v->serial_number);
}
static void imu(FILE* out, const sensor_msgs_msg_Imu* v) {
  header(out, &v->header);
  comma(out);
  numbers(out, "orientation", &v->orientation.x, 4, 1);
  comma(out);
  numbers(out, "angular_velocity", &v->angular_velocity.x, 3, 1);
  comma(out);
  numbers(out, "angular_velocity_covariance", v->angular_velocity_covariance, 3, 4);
  comma(out);
  numbers(out, "linear_acceleration", &v->linear_acceleration.x, 3, 1);
  comma(out);
  numbers(out, "linear_acceleration_covariance", v->linear_acceleration_covariance, 3, 4);
}
static void fix(FILE* out, const sensor_msgs_msg_NavSatFix* v) {
  header(out, &v->header);
  fprintf(out, ", \"status\": %d, \"service\": %u, ", v->status.status, v->status.service);
  numbers(out, "position", &v->latitude, 3, 1);  // latitude, longitude, altitude
  comma(out);
  numbers(out, "position_covariance", v->position_covariance, 3, 4);
  fprintf(out, ", \"position_covariance_type\": %u", v->position_covariance_type);
}
static void pressure(FILE* out, const sensor_msgs_msg_FluidPressure* v) {
  header(out, &v->header);
  comma(out);
  named(out, "fluid_pressure", v->fluid_pressure);
  comma(out);
  named(out, "variance", v->variance);
}
static void twist_stamped(FILE* out, const geometry_msgs_msg_TwistWithCovarianceStamped* v) {
  header(out, &v->header);
  comma(out);
  twist(out, &v->twist.twist);
  comma(out);
  numbers(out, "covariance", v->twist.covariance, 6, 7);
}
static void path(FILE* out, const nav_msgs_msg_Path* v) {
  header(out, &v->header);
  fputs(", \"poses\": [", out);
  for (uint32_t i = 0; i < v->poses._length; ++i) {
    fputs(i > 0 ? ", {" : "{", out);
    pose_stamped(out, &v->poses._buffer[i]);
    fputs("}", out);
  }
  fputs("]", out);
}
static void string(FILE* out, const std_msgs_msg_String* v) { text(out, "data", v->data); }
static void reserve(FILE* out, const slackwater_msgs_msg_Reserve* v) {
  header(out, &v->header);
  comma(out);
  named(out, "energy_left_j", v->energy_left_j);
  comma(out);
  named(out, "energy_home_j", v->energy_home_j);
  comma(out);
  named(out, "margin_s", v->margin_s);
  comma(out);
  text(out, "advice", v->advice);
}
static void feedback(FILE* out, const slackwater_msgs_action_Navigate_FeedbackMessage* v) {
  id(out, &v->goal_id);
  fprintf(out, ", \"waypoint\": %u, ", v->feedback.waypoint);
  named(out, "distance_m", v->feedback.distance_m);
}
static void status(FILE* out, const action_msgs_msg_GoalStatusArray* v) {
  fputs("\"status_list\": [", out);
  for (uint32_t i = 0; i < v->status_list._length; ++i) {
    const action_msgs_msg_GoalStatus* goal = &v->status_list._buffer[i];
    fputs(i > 0 ? ", {" : "{", out);
    id(out, &goal->goal_info.goal_id);
    comma(out);
    stamp(out, "stamp", &goal->goal_info.stamp);
    fprintf(out, ", \"status\": %d}", goal->status);
  }
  fputs("]", out);
}
static void profile(FILE* out, const slackwater_msgs_msg_CurrentProfile* v) {
  const struct {
    const char* name;
    const dds_sequence_double* values;
  } fields[] = {{"depth_m", &v->depth_m},     {"east_m_s", &v->east_m_s},
                {"north_m_s", &v->north_m_s}, {"east_p10", &v->east_p10},
                {"east_p90", &v->east_p90},   {"north_p10", &v->north_p10},
                {"north_p90", &v->north_p90}};
  header(out, &v->header);
  comma(out);
  text(out, "instance", v->instance);
  comma(out);
  named(out, "latitude", v->latitude);
  comma(out);
  named(out, "longitude", v->longitude);
  for (size_t i = 0; i < sizeof fields / sizeof fields[0]; ++i) {
    comma(out);
    sequence(out, fields[i].name, fields[i].values);
  }
}
static void vector(FILE* out, const geometry_msgs_msg_Vector3Stamped* v) {
  header(out, &v->header);
  comma(out);
  numbers(out, "vector", &v->vector.x, 3, 1);
}
static void sea(FILE* out, const slackwater_msgs_msg_SeaState* v) {
  header(out, &v->header);
  comma(out);
  named(out, "hs_m", v->hs_m);
  comma(out);
  named(out, "tp_s", v->tp_s);
  comma(out);
  named(out, "from_deg", v->from_deg);
}
static void one_number(FILE* out, const std_msgs_msg_Float64* v) { named(out, "data", v->data); }
static void array(FILE* out, const std_msgs_msg_Float64MultiArray* v) {
  fputs("\"dim\": [", out);
  for (uint32_t i = 0; i < v->layout.dim._length; ++i) {
    const std_msgs_msg_MultiArrayDimension* dim = &v->layout.dim._buffer[i];
    fputs(i > 0 ? ", {" : "{", out);
    text(out, "label", dim->label);
    fprintf(out, ", \"size\": %u, \"stride\": %u}", dim->size, dim->stride);
  }
  fprintf(out, "], \"data_offset\": %u, ", v->layout.data_offset);
  sequence(out, "data", &v->data);
}
static void target(FILE* out, const slackwater_msgs_msg_AisTarget* v) {
  header(out, &v->header);
  fprintf(out, ", \"mmsi\": %u, ", v->mmsi);
  text(out, "name", v->name);
  const struct {
    const char* name;
    double value;
  } fields[] = {{"latitude", v->latitude}, {"longitude", v->longitude}, {"sog_m_s", v->sog_m_s},
                {"cog_deg", v->cog_deg},   {"cpa_m", v->cpa_m},         {"tcpa_s", v->tcpa_s}};
  for (size_t i = 0; i < sizeof fields / sizeof fields[0]; ++i) {
    comma(out);
    named(out, fields[i].name, fields[i].value);
  }
}
static void graph(FILE* out, const rmw_dds_common_msg_ParticipantEntitiesInfo* v) {
  fputs("\"nodes\": [", out);
  for (uint32_t i = 0; i < v->node_entities_info_seq._length; ++i) {
    const rmw_dds_common_msg_NodeEntitiesInfo* node = &v->node_entities_info_seq._buffer[i];
    fputs(i > 0 ? ", {" : "{", out);
    text(out, "namespace", node->node_namespace);
    comma(out);
    text(out, "name", node->node_name);
    fprintf(out, ", \"readers\": %u, \"writers\": %u}", node->reader_gid_seq._length,
            node->writer_gid_seq._length);
  }
  fputs("]", out);
}

typedef void (*printer)(FILE*, const void*);
#define PRINTER(function) (printer)(void (*)(void))(function)

void print_json(FILE* out, const struct cyclone_type* type, const void* message) {
  static const struct {
    const char* type;
    printer print;
  } printers[] = {
      {"rosgraph_msgs/msg/Clock", PRINTER(clock_json)},
      {"nav_msgs/msg/Odometry", PRINTER(odometry)},
      {"geometry_msgs/msg/PoseStamped", PRINTER(pose_stamped)},
      {"sensor_msgs/msg/BatteryState", PRINTER(battery)},
      {"sensor_msgs/msg/Imu", PRINTER(imu)},
      {"sensor_msgs/msg/NavSatFix", PRINTER(fix)},
      {"sensor_msgs/msg/FluidPressure", PRINTER(pressure)},
      {"geometry_msgs/msg/TwistWithCovarianceStamped", PRINTER(twist_stamped)},
      {"nav_msgs/msg/Path", PRINTER(path)},
      {"std_msgs/msg/String", PRINTER(string)},
      {"slackwater_msgs/msg/Reserve", PRINTER(reserve)},
      {"slackwater_msgs/action/Navigate_FeedbackMessage", PRINTER(feedback)},
      {"action_msgs/msg/GoalStatusArray", PRINTER(status)},
      {"slackwater_msgs/msg/CurrentProfile", PRINTER(profile)},
      {"geometry_msgs/msg/Vector3Stamped", PRINTER(vector)},
      {"slackwater_msgs/msg/SeaState", PRINTER(sea)},
      {"std_msgs/msg/Float64", PRINTER(one_number)},
      {"std_msgs/msg/Float64MultiArray", PRINTER(array)},
      {"slackwater_msgs/msg/AisTarget", PRINTER(target)},
      {"rmw_dds_common/msg/ParticipantEntitiesInfo", PRINTER(graph)},
  };
  fputs("{", out);
  for (size_t i = 0; i < sizeof printers / sizeof printers[0]; ++i)
    if (strcmp(printers[i].type, type->ros_name) == 0) printers[i].print(out, message);
  fputs("}", out);
}
