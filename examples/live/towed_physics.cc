// The physics of a vehicle in another process, over Fast DDS: a body that is towed by its thrusters
// through still water around it, with drag along and across, made here instead of in the twin.
//
//   fastddsgen -typeros2 -cs -d types -I IDL IDL/*.idl       # IDL: share/slackwater/idl
//   towed_physics --domain 7 --vehicle rov [--die-after N] [--lie-after N] [--late-after N]
//
// It asks to host the physics of the vehicle, then answers each input with the state at the end of
// the step. The last three make it fail in step N, to see what becomes of the vehicle.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <limits>
#include <string>
#include <thread>

#include "slackwater_msgsPubSubTypes.h"

using namespace eprosima::fastdds::dds;
namespace msg = slackwater_msgs::msg;

namespace {

/// A reader or writer of `/VEHICLE/host/WHAT`.
template <typename Support>
Topic* topic(DomainParticipant* participant, const std::string& vehicle, const char* what) {
  const TypeSupport type(new Support);
  type.register_type(participant);
  return participant->create_topic("rt/" + vehicle + "/host/" + what, type.get_type_name(),
                                   TOPIC_QOS_DEFAULT);
}

/// A point of 12 kg that thrusters 1 to 4 push ahead with up to 50 N each, in water that drags it.
void move(const msg::PhysicsInput& in, msg::PhysicsOutput& out) {
  constexpr double mass_kg = 24, drag_n_s2_m2 = 60, thruster_n = 50;  // water carried along counts
  out.pose(in.pose());
  out.twist(in.twist());
  const auto& q = in.pose().orientation();
  const double yaw =
      std::atan2(2 * (q.w() * q.z() + q.x() * q.y()), 1 - 2 * (q.y() * q.y() + q.z() * q.z()));
  double push_n = 0;
  for (std::size_t i = 0; i < in.thrusters().size() && i < 4; ++i)
    push_n += thruster_n * in.thrusters()[i] / 4;
  const double u = in.twist().linear().x();
  const double w = in.twist().linear().z();
  const double made = u + in.dt_s() * (push_n - drag_n_s2_m2 * std::abs(u) * u) / mass_kg;
  const double sunk = w - in.dt_s() * drag_n_s2_m2 * std::abs(w) * w / mass_kg;
  out.pose().position().x(in.pose().position().x() + in.dt_s() * made * std::cos(yaw));
  out.pose().position().y(in.pose().position().y() + in.dt_s() * made * std::sin(yaw));
  out.pose().position().z(in.pose().position().z() + in.dt_s() * sunk);
  // It lies level and keeps its course.
  out.pose().orientation().x(0);
  out.pose().orientation().y(0);
  out.pose().orientation().z(std::sin(yaw / 2));
  out.pose().orientation().w(std::cos(yaw / 2));
  out.twist().linear().x(made);
  out.twist().linear().y(0);
  out.twist().linear().z(sunk);
  out.twist().angular(geometry_msgs::msg::Vector3());
  out.power_w(20 + std::abs(push_n));
}

}  // namespace

int main(int argc, char** argv) {
  unsigned domain = 0;
  std::string vehicle = "rov";
  std::uint64_t die = ~0ULL, lie = ~0ULL, late = ~0ULL;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string option = argv[i];
    if (option == "--domain") domain = static_cast<unsigned>(std::atoi(argv[i + 1]));
    if (option == "--vehicle") vehicle = argv[i + 1];
    if (option == "--die-after") die = std::strtoull(argv[i + 1], nullptr, 10);
    if (option == "--lie-after") lie = std::strtoull(argv[i + 1], nullptr, 10);
    if (option == "--late-after") late = std::strtoull(argv[i + 1], nullptr, 10);
  }
  auto* participant = DomainParticipantFactory::get_instance()->create_participant(
      static_cast<DomainId_t>(domain), PARTICIPANT_QOS_DEFAULT);
  auto* publisher = participant->create_publisher(PUBLISHER_QOS_DEFAULT);
  auto* subscriber = participant->create_subscriber(SUBSCRIBER_QOS_DEFAULT);
  DataReaderQos reliable = DATAREADER_QOS_DEFAULT;
  reliable.reliability().kind = RELIABLE_RELIABILITY_QOS;
  reliable.history().depth = 10;
  auto* request = publisher->create_datawriter(
      topic<msg::HostRequestPubSubType>(participant, vehicle, "request"), DATAWRITER_QOS_DEFAULT);
  auto* output = publisher->create_datawriter(
      topic<msg::PhysicsOutputPubSubType>(participant, vehicle, "physics_output"),
      DATAWRITER_QOS_DEFAULT);
  auto* answers = subscriber->create_datareader(
      topic<msg::HostAnswerPubSubType>(participant, vehicle, "answer"), reliable);
  auto* inputs = subscriber->create_datareader(
      topic<msg::PhysicsInputPubSubType>(participant, vehicle, "physics_input"), reliable);

  const auto token =
      static_cast<std::uint64_t>(std::chrono::steady_clock::now().time_since_epoch().count());
  bool is_taken = false;
  std::uint64_t steps = 0;
  SampleInfo info;
  for (int silent = 0; silent < 100; ++silent) {  // ten seconds of it end us
    if (!is_taken) {
      msg::HostRequest asked;
      asked.token(token);
      asked.version(1);
      asked.role(2);
      asked.timeout_s(2);
      request->write(&asked);
    }
    msg::HostAnswer answer;
    while (answers->take_next_sample(&answer, &info) == ReturnCode_t::RETCODE_OK) {
      if (answer.token() != token || is_taken) continue;
      std::fprintf(stderr, "%s\n", answer.message().c_str());
      if (!answer.success()) return 1;
      is_taken = true;
    }
    inputs->wait_for_unread_message({0, 100'000'000});
    msg::PhysicsInput in;
    while (inputs->take_next_sample(&in, &info) == ReturnCode_t::RETCODE_OK) {
      if (!info.valid_data) continue;
      silent = 0;
      ++steps;
      if (steps > die) std::abort();
      if (steps > late) std::this_thread::sleep_for(std::chrono::seconds(5));
      msg::PhysicsOutput out;
      out.step(in.step());
      out.kind(1);
      move(in, out);
      if (steps > lie) out.pose().position().x(std::numeric_limits<double>::quiet_NaN());
      output->write(&out);
    }
  }
  std::fprintf(stderr, "%llu steps made\n", static_cast<unsigned long long>(steps));
  return steps > 0 ? 0 : 1;
}
