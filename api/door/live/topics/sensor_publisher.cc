#include "api/door/live/topics/sensor_publisher.h"

#include <algorithm>
#include <cmath>

#include "api/ask/render/logged_poses.h"
#include "api/door/dds/message/names.h"
#include "api/door/live/topics/sensor_topics.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::live {
namespace {

/// Of a step, within which a moment counts as come: steps are not exact in binary.
constexpr double moment_rounding_s = 1e-6;

std::vector<std::string> names_of_all(const twin::Run& run) {
  std::vector<std::string> names;
  for (const twin::Agent& agent : run.agents()) names.push_back(agent.name);
  return names;
}

/// What is ready already is not read again.
twin::Surround with_shelves(twin::Surround surround, const twin::Run& run) {
  for (const twin::Agent& agent : run.agents())
    if (agent.inspection) surround.inspections.emplace(agent.name, agent.inspection);
  return surround;
}

}  // namespace

/// Where all were when it came.
struct SensorPublisher::Moment {
  double t_s = 0;
  LookThread::WallClock::time_point at;
  std::vector<std::optional<twin::Carriage>> vehicles;
  std::shared_ptr<const std::vector<twin::Command>> commands;
};

struct SensorPublisher::Eye {
  SensorAsked asked;
  api::MountedSensor mounted;
  std::string frame_id;
  std::uint64_t next = 0;  ///< moment, at next / rate
  struct Topic {
    Stream::ChannelId channel = 0;
    SensorTopic::ToMessage message = nullptr;
  };
  std::vector<Topic> topics;               ///< of a camera the picture comes first
  std::optional<Stream::ChannelId> finds;  ///< of a detector
};

std::string SensorTold::text() const {
  std::string text = formatted("{}/{} at {:g} Hz: {} moments, {} seen", asked.vehicle, asked.sensor,
                               asked.rate_hz, made.moments, made.looks);
  if (made.looks > 0)
    text +=
        formatted(" on average {:.3f} s after ({:.3f} s at worst)", made.mean_s(), made.worst_s);
  if (made.dropped > 0)
    text += formatted(", {} left out as the one before was not done", made.dropped);
  if (made.unseen > 0) text += formatted(", {} when it could not see", made.unseen);
  return text;
}

SensorPublisher::SensorPublisher(Stream& stream, const RunPlace& place, const api::RunInHand& hand,
                                 const std::vector<std::string>& names, const SensorsAsked& asked,
                                 OnPicture on_picture,
                                 std::function<void(const std::string&)> on_trouble)
    : stream_(stream),
      place_(place),
      run_(hand.run),
      on_picture_(std::move(on_picture)),
      vehicles_(hand.run.agents().size()),
      seen_(hand.scenario, with_shelves(hand.water.surround, hand.run), names_of_all(hand.run)),
      commands_(std::make_shared<const std::vector<twin::Command>>()) {
  const auto first = moment(hand.run.time_s());
  for (const SensorAsked& one : asked.sensors) {
    with_context(formatted("--see {}/{}", one.vehicle, one.sensor), [&] {
      const bool is_known = std::any_of(eyes_.begin(), eyes_.end(), [&](const Eye& eye) {
        return eye.asked.vehicle == one.vehicle && eye.asked.sensor == one.sensor;
      });
      if (is_known)
        throw Error(ErrorKind::invalid_input,
                    "found it twice, expected once with the rate that is meant");
      Eye eye = eye_of(one, asked.sight, hand);
      seen_.expect_sees(eye.mounted, {first->t_s, first->vehicles, *first->commands});
      eyes_.push_back(std::move(eye));
    });
  }
  if (!asked.by.empty()) {
    if (std::none_of(eyes_.begin(), eyes_.end(),
                     [](const Eye& eye) { return eye.mounted.sensor.is_camera(); }))
      throw Error(ErrorKind::usage,
                  "--by: found no camera among the sensors; put one on a vehicle by --see");
    with_context("--by", [&] { detector_ = api::load_detector(asked.by); });
  }
  for (Eye& eye : eyes_) open_topics(eye, names.at(eye.mounted.vehicle));
  const auto on_unseen = [this, on_trouble = std::move(on_trouble)](std::size_t sensor,
                                                                    const std::string& why) {
    const SensorAsked& of = eyes_[sensor].asked;
    if (on_trouble)
      on_trouble(formatted("{}/{} does not see for now: {}", of.vehicle, of.sensor, why));
  };
  thread_ = std::make_unique<LookThread>(eyes_.size(), on_unseen);
}

SensorPublisher::~SensorPublisher() = default;

SensorPublisher::Eye SensorPublisher::eye_of(const SensorAsked& asked,
                                             const api::SightChoice& sight,
                                             const api::RunInHand& hand) {
  const std::vector<std::string> all = names_of_all(hand.run);
  const auto vehicle = std::find(all.begin(), all.end(), asked.vehicle);
  if (vehicle == all.end())
    throw Error(ErrorKind::not_found,
                formatted("found no vehicle {}; the run has {}", asked.vehicle, joined(all, ", ")));
  if (const double most_hz = 1 / hand.run.step_s(); asked.rate_hz > most_hz * (1 + 1e-9))
    throw Error(ErrorKind::invalid_input,
                formatted("found {:g} Hz, expected at most {:g} Hz: one each step of {:g} s",
                          asked.rate_hz, most_hz, hand.run.step_s()));
  const std::filesystem::path& data = hand.water.surround.data_folder;
  Eye eye;
  eye.asked = asked;
  eye.mounted = api::mounted_sensor(asked.sensor, static_cast<std::size_t>(vehicle - all.begin()),
                                    sight, data);
  return eye;
}

void SensorPublisher::open_topics(Eye& eye, const std::string& name) {
  eye.frame_id = name + "/" + dds::ros_token(eye.asked.sensor);
  for (const SensorTopic& topic : topics_of(eye.mounted.sensor))
    eye.topics.push_back(
        {stream_.open("/" + eye.frame_id + "/" + topic.name, topic.type, sensor_quality),
         topic.message});
  if (detector_ && eye.mounted.sensor.is_camera())
    eye.finds =
        stream_.open("/" + eye.frame_id + "/" + detections_topic, detections_type, sensor_quality);
}

std::shared_ptr<const SensorPublisher::Moment> SensorPublisher::moment(double t_s) {
  const auto commands = run_.commands_taken();
  for (; commands_looked_at_ < commands.size(); ++commands_looked_at_) {
    const twin::Command& command = commands[commands_looked_at_];
    if (!api::changes_the_view(command)) continue;
    auto more = std::make_shared<std::vector<twin::Command>>(*commands_);
    more->push_back(command);
    commands_ = std::move(more);
  }
  auto now = std::make_shared<Moment>();
  now->t_s = t_s;
  now->at = LookThread::WallClock::now();
  now->commands = commands_;
  const auto states = run_.states();
  for (std::size_t i = 0; i < vehicles_; ++i)
    now->vehicles.push_back(api::carriage_as_logged(states[i].vehicle.body));
  return now;
}

void SensorPublisher::look(const Eye& eye, const Moment& moment,
                           const std::vector<bool>& is_wanted) {
  if (!moment.vehicles[eye.mounted.vehicle])
    throw Error(ErrorKind::unavailable, "its vehicle has come to grief");
  const api::RenderView view =
      seen_.look(eye.mounted, {moment.t_s, moment.vehicles, *moment.commands});
  auto jpeg = std::make_shared<std::vector<std::uint8_t>>();
  const bool has_picture = shows_pictures(eye.mounted.sensor);
  if (has_picture && (on_picture_ || is_wanted.front())) *jpeg = jpeg_of_view(view);
  const SeenView seen{eye.mounted.sensor, view, *jpeg};
  const dds::SensorStamp of{dds::stamp_of(place_.epoch, moment.t_s), eye.frame_id};
  std::vector<Made> made;
  for (std::size_t i = 0; i < eye.topics.size(); ++i)
    if (is_wanted[i]) made.push_back({eye.topics[i].channel, eye.topics[i].message(seen, of)});
  if (eye.finds && is_wanted.back()) {
    const auto found = detector_->find(std::get<api::CameraView>(view.seen).picture);
    made.push_back({*eye.finds, detections_message_of(found, of)});
  }
  {
    const std::lock_guard lock(mutex_);
    std::move(made.begin(), made.end(), std::back_inserter(made_));
  }
  if (has_picture && on_picture_) {
    const auto [wide, high] = size_of_picture(view);
    on_picture_({eye.mounted.vehicle, eye.asked.sensor, moment.t_s, moment.at, wide, high,
                 std::move(jpeg)});
  }
}

/// Recorded when it is told, and not in the past: the moment is in its header.
void SensorPublisher::tell(double t_s) {
  std::vector<Made> made;
  {
    const std::lock_guard lock(mutex_);
    made.swap(made_);
  }
  const dds::Stamp now = dds::stamp_of(place_.epoch, t_s);
  for (const Made& one : made) stream_.publish(one.channel, now, one.message);
}

void SensorPublisher::speak(double t_s) {
  tell(t_s);
  std::shared_ptr<const Moment> now;  // the same for all
  for (std::size_t i = 0; i < eyes_.size(); ++i) {
    Eye& eye = eyes_[i];
    const double rate_hz = eye.asked.rate_hz;
    if (t_s + moment_rounding_s < static_cast<double>(eye.next) / rate_hz) continue;
    eye.next = static_cast<std::uint64_t>(std::floor((t_s + moment_rounding_s) * rate_hz)) + 1;
    std::vector<bool> is_wanted;
    for (const Eye::Topic& topic : eye.topics)
      is_wanted.push_back(stream_.is_wanted(topic.channel));
    if (eye.finds) is_wanted.push_back(stream_.is_wanted(*eye.finds));
    const bool is_shown = on_picture_ && shows_pictures(eye.mounted.sensor);
    if (!is_shown && std::find(is_wanted.begin(), is_wanted.end(), true) == is_wanted.end())
      continue;
    if (!now) now = moment(t_s);
    thread_->hand_in(i, [this, &eye = std::as_const(eye), now, is_wanted = std::move(is_wanted)] {
      look(eye, *now, is_wanted);
    });
  }
}

void SensorPublisher::finish(double t_s) {
  thread_->finish();
  tell(t_s);
}

std::vector<SensorTold> SensorPublisher::told() const {
  std::vector<SensorTold> told;
  for (std::size_t i = 0; i < eyes_.size(); ++i) told.push_back({eyes_[i].asked, thread_->made(i)});
  return told;
}

}  // namespace slackwater::live
