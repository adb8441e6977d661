// A robot's program as others would write it: Cyclone DDS in C, types made by idlc, ROS 2's names.
//
//   cyclone_peer listen    [OPTIONS]           hears every topic of a vehicle and a site; at the
//                                              end one line of JSON for each topic:
//        {"topic": "/rov/pose", "type": "...", "count": 12, "rate_hz": 10.1, "first": {..}, "last": {..}}
//        rate_hz: over the time between first and last, 0 where fewer than two came
//   cyclone_peer echo TOPIC [OPTIONS]          one line of JSON for each sample, as it comes
//   cyclone_peer cmd_vel   [OPTIONS] SURGE SWAY HEAVE YAW_RATE     forward, left, up; m/s, rad/s
//   cyclone_peer thrusters [OPTIONS] U...                          -1 to 1 each
//   cyclone_peer waypoints [OPTIONS] EAST,NORTH,UP...              m, in `map`
//
//   --domain N    (0)       --vehicle NAME (rov)     --site NAME (site)
//   --seconds S   (5)       how long; listen ends sooner where each topic with --enough N has come
//   --enough N    (0: never) samples of each topic
//   --hz H        (10)      how often a command is sent; 0: once
//   --wait S      (10)      for somebody who hears a command
//
// Exit code 1: nobody heard the command, or a topic was not heard at all; 2: usage. What Cyclone
// needs to know of the network is in CYCLONEDDS_URI; on one machine:
//
//   <CycloneDDS><Domain><General><Interfaces><NetworkInterface name="lo" multicast="true"/>
//   </Interfaces></General></Domain></CycloneDDS>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cyclone_json.h"
#include "cyclone_types.h"

enum quality { STATE, SENSOR, LATCHED };

struct channel {
  const char* topic;  ///< of ROS; %s: the vehicle, or the site
  char whose;         ///< 'v', 's' or '-'
  const char* type;
  enum quality quality;
};

/// The table "Slackwater's names on DDS", what it tells.
static const struct channel told[] = {
    {"/clock", '-', "rosgraph_msgs/msg/Clock", SENSOR},
    {"/%s/odometry", 'v', "nav_msgs/msg/Odometry", STATE},
    {"/%s/pose", 'v', "geometry_msgs/msg/PoseStamped", STATE},
    {"/%s/battery_state", 'v', "sensor_msgs/msg/BatteryState", LATCHED},
    {"/%s/imu", 'v', "sensor_msgs/msg/Imu", SENSOR},
    {"/%s/nav_sat_fix", 'v', "sensor_msgs/msg/NavSatFix", SENSOR},
    {"/%s/fluid_pressure", 'v', "sensor_msgs/msg/FluidPressure", SENSOR},
    {"/%s/dvl", 'v', "geometry_msgs/msg/TwistWithCovarianceStamped", SENSOR},
    {"/%s/dvl_water", 'v', "geometry_msgs/msg/TwistWithCovarianceStamped", SENSOR},
    {"/%s/active_waypoints", 'v', "nav_msgs/msg/Path", LATCHED},
    {"/%s/mission_state", 'v', "std_msgs/msg/String", LATCHED},
    {"/%s/reserve", 'v', "slackwater_msgs/msg/Reserve", STATE},
    {"/%s/navigate/_action/feedback", 'v', "slackwater_msgs/action/Navigate_FeedbackMessage",
     STATE},
    {"/%s/navigate/_action/status", 'v', "action_msgs/msg/GoalStatusArray", LATCHED},
    {"/%s/current_profile", 's', "slackwater_msgs/msg/CurrentProfile", LATCHED},
    {"/%s/wind", 's', "geometry_msgs/msg/Vector3Stamped", LATCHED},
    {"/%s/wave", 's', "slackwater_msgs/msg/SeaState", LATCHED},
    {"/%s/tide_level", 's', "std_msgs/msg/Float64", LATCHED},
    {"/%s/turbine_power", 's', "std_msgs/msg/Float64MultiArray", LATCHED},
    {"/ais", '-', "slackwater_msgs/msg/AisTarget", STATE},
    {"ros_discovery_info", '-', "rmw_dds_common/msg/ParticipantEntitiesInfo", LATCHED},
};
enum { TOLD = sizeof told / sizeof told[0] };

struct options {
  dds_domainid_t domain;
  const char *vehicle, *site;
  double seconds, hz, wait;
  long enough;
  char** rest;  ///< what is no option
  int rest_count;
};

static void die(const char* what, const char* of) {
  fprintf(stderr, "cyclone_peer: %s: %s\n", of, what);
  exit(2);
}

static struct options read_options(int argc, char** argv) {
  struct options o = {0, "rov", "site", 5, 10, 10, 0, NULL, 0};
  o.rest = calloc((size_t)argc, sizeof *o.rest);
  for (int i = 0; i < argc; ++i) {
    if (strncmp(argv[i], "--", 2) != 0) {
      o.rest[o.rest_count++] = argv[i];
      continue;
    }
    if (i + 1 == argc) die("wants a value", argv[i]);
    const char* value = argv[i + 1];
    if (strcmp(argv[i], "--domain") == 0)
      o.domain = (dds_domainid_t)atoi(value);
    else if (strcmp(argv[i], "--vehicle") == 0)
      o.vehicle = value;
    else if (strcmp(argv[i], "--site") == 0)
      o.site = value;
    else if (strcmp(argv[i], "--seconds") == 0)
      o.seconds = atof(value);
    else if (strcmp(argv[i], "--hz") == 0)
      o.hz = atof(value);
    else if (strcmp(argv[i], "--wait") == 0)
      o.wait = atof(value);
    else if (strcmp(argv[i], "--enough") == 0)
      o.enough = atol(value);
    else
      die("no such option", argv[i]);
    ++i;
  }
  return o;
}

/// "/rov/pose" -> "rt/rov/pose"; a name without a slash is one of DDS.
static void dds_name(const char* ros_topic, char* name, size_t size) {
  snprintf(name, size, "%s%s", ros_topic[0] == '/' ? "rt" : "", ros_topic);
}

static dds_qos_t* qos_of(enum quality quality) {
  dds_qos_t* qos = dds_create_qos();
  dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, quality == LATCHED ? 1 : quality == STATE ? 10 : 5);
  dds_qset_reliability(qos,
                       quality == SENSOR ? DDS_RELIABILITY_BEST_EFFORT : DDS_RELIABILITY_RELIABLE,
                       DDS_MSECS(100));
  dds_qset_durability(
      qos, quality == LATCHED ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  return qos;
}

static dds_entity_t joined(const struct options* o) {
  const dds_entity_t participant = dds_create_participant(o->domain, NULL, NULL);
  if (participant < 0) die(dds_strretcode(participant), "participant");
  return participant;
}

static void wait_ms(int ms) { dds_sleepfor(DDS_MSECS(ms)); }

/// What was heard of a topic.
struct heard {
  char topic[200];
  const struct cyclone_type* type;
  dds_entity_t reader;
  long count;
  dds_time_t first_at, last_at;
  void *first, *last;  ///< samples of DDS, kept until the end
};

static void open_reader(dds_entity_t participant, const struct channel* channel,
                        const struct options* o, struct heard* heard) {
  snprintf(heard->topic, sizeof heard->topic, channel->topic,
           channel->whose == 's' ? o->site : o->vehicle);
  heard->type = cyclone_type_named(channel->type);
  if (heard->type == NULL) die("no such type", channel->type);
  char name[256];
  dds_name(heard->topic, name, sizeof name);
  const dds_entity_t topic = topic_of(participant, heard->type, name);
  if (topic < 0) die(dds_strretcode(topic), name);
  dds_qos_t* qos = qos_of(channel->quality);
  heard->reader = dds_create_reader(participant, topic, qos, NULL);
  dds_delete_qos(qos);
  if (heard->reader < 0) die(dds_strretcode(heard->reader), name);
}

/// Takes one sample. @return NULL where there is none
static void* taken(const struct heard* heard) {
  void* sample = dds_alloc(heard->type->descriptor->m_size);
  memset(sample, 0, heard->type->descriptor->m_size);
  dds_sample_info_t info;
  while (dds_take(heard->reader, &sample, &info, 1, 1) == 1)
    if (info.valid_data) return sample;
  dds_sample_free(sample, heard->type->descriptor, DDS_FREE_ALL);
  return NULL;
}

static void hear(struct heard* heard) {
  for (void* sample; (sample = taken(heard)) != NULL;) {
    heard->last_at = dds_time();
    if (heard->count++ == 0) {
      heard->first_at = heard->last_at;
      heard->first = sample;
      continue;
    }
    if (heard->last != NULL) dds_sample_free(heard->last, heard->type->descriptor, DDS_FREE_ALL);
    heard->last = sample;
  }
}

static void print(const struct heard* heard) {
  const double span_s = (double)(heard->last_at - heard->first_at) / 1e9;
  printf("{\"topic\": \"%s\", \"type\": \"%s\", \"count\": %ld, \"rate_hz\": %.4g", heard->topic,
         heard->type->ros_name, heard->count,
         heard->count > 1 && span_s > 0 ? (double)(heard->count - 1) / span_s : 0);
  if (heard->count > 0) {
    printf(", \"first\": ");
    print_json(stdout, heard->type, heard->first);
    printf(", \"last\": ");
    print_json(stdout, heard->type, heard->last != NULL ? heard->last : heard->first);
  }
  puts("}");
}

static int run_listen(const struct options* o) {
  const dds_entity_t participant = joined(o);
  static struct heard heard[TOLD];
  for (int i = 0; i < TOLD; ++i) open_reader(participant, &told[i], o, &heard[i]);
  const dds_time_t end = dds_time() + (dds_time_t)(o->seconds * 1e9);
  for (int all = 0; !all && dds_time() < end; wait_ms(1)) {
    all = o->enough > 0;
    for (int i = 0; i < TOLD; ++i) {
      hear(&heard[i]);
      all = all && heard[i].count >= o->enough;
    }
  }
  int silent = 0;
  for (int i = 0; i < TOLD; ++i) {
    print(&heard[i]);
    silent += heard[i].count == 0;
  }
  dds_delete(participant);
  return silent > 0 ? 1 : 0;
}

static int run_echo(const struct options* o) {
  if (o->rest_count != 1) die("wants one topic", "echo");
  const dds_entity_t participant = joined(o);
  struct heard heard = {0};
  for (int i = 0; i < TOLD && heard.reader == 0; ++i) {
    char topic[200];
    snprintf(topic, sizeof topic, told[i].topic, told[i].whose == 's' ? o->site : o->vehicle);
    if (strcmp(topic, o->rest[0]) == 0) open_reader(participant, &told[i], o, &heard);
  }
  if (heard.reader == 0) die("no such topic", o->rest[0]);
  const dds_time_t end = dds_time() + (dds_time_t)(o->seconds * 1e9);
  for (; dds_time() < end && (o->enough == 0 || heard.count < o->enough); wait_ms(1)) {
    for (void* sample; (sample = taken(&heard)) != NULL; ++heard.count) {
      print_json(stdout, heard.type, sample);
      puts("");
      fflush(stdout);
      dds_sample_free(sample, heard.type->descriptor, DDS_FREE_ALL);
    }
  }
  dds_delete(participant);
  return heard.count > 0 ? 0 : 1;
}

/// Sends until the time is over, as soon as somebody hears it.
static int send(const struct options* o, const char* topic_name, const char* type_name,
                const void* message) {
  const dds_entity_t participant = joined(o);
  char ros_topic[200], name[256];
  snprintf(ros_topic, sizeof ros_topic, "/%s/%s", o->vehicle, topic_name);
  dds_name(ros_topic, name, sizeof name);
  const dds_entity_t topic = topic_of(participant, cyclone_type_named(type_name), name);
  dds_qos_t* qos = qos_of(STATE);
  const dds_entity_t writer = dds_create_writer(participant, topic, qos, NULL);
  dds_delete_qos(qos);
  if (writer < 0) die(dds_strretcode(writer), name);
  const dds_time_t patience = dds_time() + (dds_time_t)(o->wait * 1e9);
  dds_publication_matched_status_t matched = {0};
  while (dds_get_publication_matched_status(writer, &matched) == 0 && matched.current_count == 0) {
    if (dds_time() > patience) {
      fprintf(stderr, "cyclone_peer: nobody hears %s\n", ros_topic);
      dds_delete(participant);
      return 1;
    }
    wait_ms(5);
  }
  const dds_time_t end = dds_time() + (dds_time_t)(o->seconds * 1e9);
  long count = 0;
  do {
    if (dds_write(writer, message) != DDS_RETCODE_OK) die("cannot be written", name);
    ++count;
    if (o->hz > 0) dds_sleepfor((dds_duration_t)(1e9 / o->hz));
  } while (o->hz > 0 && dds_time() < end);
  // What was lost is asked for again.
  dds_wait_for_acks(writer, DDS_SECS(5));
  printf("{\"topic\": \"%s\", \"sent\": %ld}\n", ros_topic, count);
  dds_delete(participant);
  return 0;
}

static int run_cmd_vel(const struct options* o) {
  if (o->rest_count != 4) die("wants surge, sway, heave and yaw rate", "cmd_vel");
  geometry_msgs_msg_Twist twist = {{atof(o->rest[0]), atof(o->rest[1]), atof(o->rest[2])},
                                   {0, 0, atof(o->rest[3])}};
  return send(o, "cmd_vel", "geometry_msgs/msg/Twist", &twist);
}

static int run_thrusters(const struct options* o) {
  std_msgs_msg_Float64MultiArray array;
  memset(&array, 0, sizeof array);
  array.data._length = array.data._maximum = (uint32_t)o->rest_count;
  array.data._buffer = calloc((size_t)o->rest_count + 1, sizeof(double));
  for (int i = 0; i < o->rest_count; ++i) array.data._buffer[i] = atof(o->rest[i]);
  const int code = send(o, "thrusters", "std_msgs/msg/Float64MultiArray", &array);
  free(array.data._buffer);
  return code;
}

static int run_waypoints(const struct options* o) {
  static char map[] = "map";
  nav_msgs_msg_Path path;
  memset(&path, 0, sizeof path);
  path.header.frame_id = map;
  path.poses._length = path.poses._maximum = (uint32_t)o->rest_count;
  path.poses._buffer = calloc((size_t)o->rest_count + 1, sizeof *path.poses._buffer);
  for (int i = 0; i < o->rest_count; ++i) {
    geometry_msgs_msg_PoseStamped* place = &path.poses._buffer[i];
    place->header.frame_id = map;
    place->pose.orientation.w = 1;
    geometry_msgs_msg_Point* at = &place->pose.position;
    if (sscanf(o->rest[i], "%lf,%lf,%lf", &at->x, &at->y, &at->z) != 3)
      die("is no EAST,NORTH,UP", o->rest[i]);
  }
  struct options once = *o;
  once.hz = 0;
  const int code = send(&once, "waypoints", "nav_msgs/msg/Path", &path);
  free(path.poses._buffer);
  return code;
}

int main(int argc, char** argv) {
  static const struct {
    const char* name;
    int (*run)(const struct options*);
  } commands[] = {{"listen", run_listen},
                  {"echo", run_echo},
                  {"cmd_vel", run_cmd_vel},
                  {"thrusters", run_thrusters},
                  {"waypoints", run_waypoints}};
  const struct options o = argc > 1 ? read_options(argc - 2, argv + 2) : (struct options){0};
  for (size_t i = 0; argc > 1 && i < sizeof commands / sizeof commands[0]; ++i)
    if (strcmp(argv[1], commands[i].name) == 0) return commands[i].run(&o);
  fprintf(stderr, "cyclone_peer listen | echo | cmd_vel | thrusters | waypoints ...\n");
  return 2;
}
