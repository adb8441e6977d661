#include "api/door/live/sensor_publisher.h"

#include <algorithm>
#include <cmath>

#include "api/ask/render/logged_poses.h"
#include "api/door/dds/message/names.h"
#include "api/door/dds/message/sensor_messages.h"
#include "api/door/dds/message/sonar_messages.h"
#include "api/perception/jpeg.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/render/light/heat_tones.h"

namespace slackwater::live {
namespace {

/// Of a step, within which a moment counts as come: steps are not exact in binary.
constexpr double moment_rounding_s = 1e-6;

/// Of cameras, of light or of heat: they have a picture for people, and a picture's size.
struct CameraFrame {
  const twin::TruthFrame& truth;
  const std::array<double, 9>& matrix;
};
std::optional<CameraFrame> camera_frame(const api::RenderView& view) {
  if (const auto* camera = std::get_if<api::CameraView>(&view.seen))
    return CameraFrame{camera->truth, camera->matrix};
  if (const auto* infrared = std::get_if<api::InfraredView>(&view.seen))
    return CameraFrame{infrared->truth, infrared->matrix};
  return std::nullopt;
}
bool shows_pictures(const twin::RenderSensor& sensor) {
  return sensor.is_camera() || std::holds_alternative<twin::InfraredSheet>(sensor.device);
}

std::vector<std::uint8_t> jpeg_of_heat(const twin::InfraredFrame& heat) {
  twin::Picture grey{heat.wide, heat.high, {}};
  for (const std::uint8_t tone : twin::heat_tones(heat)) grey.rgb.insert(grey.rgb.end(), 3, tone);
  return api::jpeg_of(grey);
}
std::vector<std::uint8_t> jpeg_of_view(const api::RenderView& view) {
  if (const auto* camera = std::get_if<api::CameraView>(&view.seen))
    return api::jpeg_of(camera->picture);
  return jpeg_of_heat(std::get<api::InfraredView>(view.seen).heat);
}

/// What was seen, and the JPEG of it where one is needed.
struct Seen {
  const twin::RenderSensor& sensor;
  const api::RenderView& view;
  const std::vector<std::uint8_t>& jpeg;
};
using ToMessage = dds::Bytes (*)(const Seen& seen, const dds::SensorStamp& of);

template <dds::SensorAxes axes>
dds::Bytes pose_message_of(const Seen& seen, const dds::SensorStamp& of) {
  return dds::sensor_pose(seen.view.pose, axes, of.stamp);
}
dds::Bytes image_message_of(const Seen& seen, const dds::SensorStamp& of) {
  return dds::compressed_image(seen.jpeg, of);
}
dds::Bytes info_message_of(const Seen& seen, const dds::SensorStamp& of) {
  const CameraFrame frame = *camera_frame(seen.view);
  return dds::camera_info(frame.truth.wide, frame.truth.high, frame.matrix, of);
}
dds::Bytes depth_message_of(const Seen& seen, const dds::SensorStamp& of) {
  return dds::depth_image(camera_frame(seen.view)->truth, of);
}
const api::RightView& right_of(const Seen& seen) {
  return *std::get<api::CameraView>(seen.view.seen).right;
}
dds::Bytes right_image_message_of(const Seen& seen, const dds::SensorStamp& of) {
  return dds::compressed_image(api::jpeg_of(right_of(seen).picture), of);
}
dds::Bytes right_info_message_of(const Seen& seen, const dds::SensorStamp& of) {
  const api::RightView& right = right_of(seen);
  return dds::camera_info(right.picture.wide, right.picture.high, camera_frame(seen.view)->matrix,
                          of, right.baseline_m);
}
dds::Bytes heat_message_of(const Seen& seen, const dds::SensorStamp& of) {
  return dds::heat_image(std::get<api::InfraredView>(seen.view.seen).heat, of);
}
dds::Bytes points_message_of(const Seen& seen, const dds::SensorStamp& of) {
  return dds::point_cloud(std::get<twin::LidarScan>(seen.view.seen),
                          std::get<twin::LidarSheet>(seen.sensor.device), of);
}
dds::Bytes sonar_message_of(const Seen& seen, const dds::SensorStamp& of) {
  return dds::sonar_image(std::get<twin::SonarImage>(seen.view.seen),
                          std::get<twin::ImagingSonarSheet>(seen.sensor.device),
                          seen.sensor.most_range_m, of);
}
dds::Bytes side_scan_message_of(const Seen& seen, const dds::SensorStamp& of) {
  return dds::side_scan_image(std::get<twin::SideScanPing>(seen.view.seen),
                              std::get<twin::SideScanSheet>(seen.sensor.device), of);
}
dds::Bytes ranges_message_of(const Seen& seen, const dds::SensorStamp& of) {
  return dds::sonar_ranges(std::get<api::MultibeamView>(seen.view.seen).soundings,
                           std::get<twin::MultibeamSheet>(seen.sensor.device), of);
}
dds::Bytes range_message_of(const Seen& seen, const dds::SensorStamp& of) {
  return dds::range_message(std::get<twin::EchoSounding>(seen.view.seen),
                            std::get<twin::EchoSounderSheet>(seen.sensor.device),
                            {seen.sensor.least_range_m, seen.sensor.most_range_m}, of);
}
dds::Bytes currents_message_of(const Seen& seen, const dds::SensorStamp& of) {
  return dds::current_cloud(std::get<twin::CurrentProfile>(seen.view.seen), of);
}

struct SensorTopic {
  const char* name;
  const char* type;
  ToMessage message;
};
using SensorTopics = std::vector<SensorTopic>;

template <dds::SensorAxes axes>
constexpr SensorTopic pose_topic{"pose", "geometry_msgs/msg/PoseStamped", pose_message_of<axes>};
constexpr SensorTopic camera_pose = pose_topic<dds::SensorAxes::camera>;
constexpr SensorTopic scanner_pose = pose_topic<dds::SensorAxes::scanner>;
constexpr SensorTopic fan_pose = pose_topic<dds::SensorAxes::fan>;
constexpr SensorTopic image_topic{"image/compressed", "sensor_msgs/msg/CompressedImage",
                                  image_message_of};
constexpr SensorTopic info_topic{"camera_info", "sensor_msgs/msg/CameraInfo", info_message_of};
constexpr SensorTopic depth_topic{"depth", "sensor_msgs/msg/Image", depth_message_of};

/// By device; of cameras the picture comes first.
struct TopicsOf {
  SensorTopics operator()(const twin::CameraSheet& sheet) const {
    SensorTopics topics{image_topic, info_topic, depth_topic, camera_pose};
    if (sheet.baseline_m > 0) {
      topics.push_back(
          {"right/image/compressed", "sensor_msgs/msg/CompressedImage", right_image_message_of});
      topics.push_back({"right/camera_info", "sensor_msgs/msg/CameraInfo", right_info_message_of});
    }
    return topics;
  }
  SensorTopics operator()(const twin::InfraredSheet&) const {
    return {image_topic,
            info_topic,
            depth_topic,
            {"temperature", "sensor_msgs/msg/Image", heat_message_of},
            camera_pose};
  }
  SensorTopics operator()(const twin::LidarSheet&) const {
    return {{"points", "sensor_msgs/msg/PointCloud2", points_message_of}, scanner_pose};
  }
  SensorTopics operator()(const twin::ImagingSonarSheet&) const {
    return {{"sonar", "marine_acoustic_msgs/msg/ProjectedSonarImage", sonar_message_of}, fan_pose};
  }
  SensorTopics operator()(const twin::SideScanSheet&) const {
    return {{"sonar", "marine_acoustic_msgs/msg/ProjectedSonarImage", side_scan_message_of},
            fan_pose};
  }
  SensorTopics operator()(const twin::MultibeamSheet&) const {
    return {{"ranges", "marine_acoustic_msgs/msg/SonarRanges", ranges_message_of}, fan_pose};
  }
  SensorTopics operator()(const twin::EchoSounderSheet&) const {
    return {{"range", "sensor_msgs/msg/Range", range_message_of}, scanner_pose};
  }
  SensorTopics operator()(const twin::Adcp&) const {
    return {{"currents", "sensor_msgs/msg/PointCloud2", currents_message_of}, scanner_pose};
  }
};

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
    ToMessage message = nullptr;
  };
  std::vector<Topic> topics;  ///< of a camera the picture comes first
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
  for (const SensorTopic& topic : std::visit(TopicsOf{}, eye.mounted.sensor.device))
    eye.topics.push_back(
        {stream_.open("/" + eye.frame_id + "/" + topic.name, topic.type, sensor_quality),
         topic.message});
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
  const std::optional<CameraFrame> camera = camera_frame(view);
  if (camera && (on_picture_ || is_wanted.front())) *jpeg = jpeg_of_view(view);
  const Seen seen{eye.mounted.sensor, view, *jpeg};
  const dds::SensorStamp of{dds::stamp_of(place_.epoch, moment.t_s), eye.frame_id};
  std::vector<Made> made;
  for (std::size_t i = 0; i < eye.topics.size(); ++i)
    if (is_wanted[i]) made.push_back({eye.topics[i].channel, eye.topics[i].message(seen, of)});
  {
    const std::lock_guard lock(mutex_);
    std::move(made.begin(), made.end(), std::back_inserter(made_));
  }
  if (camera && on_picture_)
    on_picture_({eye.mounted.vehicle, eye.asked.sensor, moment.t_s, moment.at, camera->truth.wide,
                 camera->truth.high, std::move(jpeg)});
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
