#pragma once
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "api/ask/render/seen_run.h"
#include "api/ask/run/scenario_run.h"
#include "api/door/live/topics/look_thread.h"
#include "api/door/live/topics/sensor_asked.h"
#include "api/door/live/topics/stream.h"
#include "api/door/live/topics/vehicle_publisher.h"
#include "api/perception/detector.h"

namespace slackwater::live {

/// What a camera saw, for people.
struct SensorPicture {
  std::size_t vehicle = 0;               ///< its place in the run
  std::string sensor;                    ///< of data/sensors
  double t_s = 0;                        ///< of the run: the moment
  LookThread::WallClock::time_point at;  ///< the same, by the clock
  int wide = 0;
  int high = 0;
  std::shared_ptr<const std::vector<std::uint8_t>> jpeg;
};
/// On a thread of its own; while it is at work no further picture is made.
using OnPicture = std::function<void(const SensorPicture&)>;

/// How a sensor fared, told at the end.
struct SensorTold {
  SensorAsked asked;
  LooksMade made;
  /// "rov/rov_camera at 2 Hz: 240 moments, 239 seen on average 0.142 s after (0.31 s at worst), 1
  /// left out as the one before was not done".
  [[nodiscard]] std::string text() const;
};

/// The sensors that are put on the vehicles of a live run: at their rates they see what the log of
/// the run will show them (`api::RenderedRun`), to the last bit at each time of its rows. Scene and
/// light are worked out on a thread of their own (`LookThread`): the run hands on where its
/// vehicles are and goes on. What is seen is told at the barrier that follows, with the stamp of
/// its moment; nothing is looked at that nobody hears.
class SensorPublisher {
 public:
  /// @param names       of the vehicles on topics, in the order of the run
  /// @param on_picture  null: no people look on
  /// @param on_trouble  told once of a sensor that cannot see; may be null
  /// @throws Error(not_found), Error(invalid_input), before anything of it is on the stream, for a
  ///         vehicle, a sensor or a detector that is not there, one that is asked for twice, more
  ///         pictures than steps, a sensor outside of its medium; Error(usage) for a detector
  ///         without a camera
  SensorPublisher(Stream& stream, const RunPlace& place, const api::RunInHand& hand,
                  const std::vector<std::string>& names, const SensorsAsked& asked,
                  OnPicture on_picture, std::function<void(const std::string&)> on_trouble);
  ~SensorPublisher();
  SensorPublisher(const SensorPublisher&) = delete;
  SensorPublisher& operator=(const SensorPublisher&) = delete;

  /// After each barrier, on the thread of the run.
  void speak(double t_s);
  /// After the last one: waits for the looks that are under way, and tells of them.
  void finish(double t_s);
  [[nodiscard]] std::vector<SensorTold> told() const;

 private:
  struct Moment;
  struct Eye;
  [[nodiscard]] static Eye eye_of(const SensorAsked& asked, const api::SightChoice& sight,
                                  const api::RunInHand& hand);
  void open_topics(Eye& eye, const std::string& name);
  [[nodiscard]] std::shared_ptr<const Moment> moment(double t_s);
  void look(const Eye& eye, const Moment& moment, const std::vector<bool>& is_wanted);
  void tell(double t_s);

  struct Made {
    Stream::ChannelId channel = 0;
    dds::Bytes message;
  };

  Stream& stream_;
  RunPlace place_;
  twin::Run& run_;
  OnPicture on_picture_;
  std::size_t vehicles_;  ///< those that were there at the start
  api::SeenRun seen_;     ///< of the look thread alone, once that is there
  std::vector<Eye> eyes_;
  std::unique_ptr<api::Detector> detector_;  ///< of the look thread alone; may be null
  std::size_t commands_looked_at_ = 0;
  /// Those that change the view, so far; others when there is a new one.
  std::shared_ptr<const std::vector<twin::Command>> commands_;

  std::mutex mutex_;
  std::vector<Made> made_;
  std::unique_ptr<LookThread> thread_;  ///< goes first
};

}  // namespace slackwater::live
