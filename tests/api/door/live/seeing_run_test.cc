// A live run whose vehicles carry sensors: what they tell is what the run's log shows afterwards,
// and the run goes on however long a look takes.
#include <cmath>
#include <map>
#include <thread>

#include "api/ask/render/rendered_run.h"
#include "api/door/dds/message/sonar_messages.h"
#include "api/door/live/live_run.h"
#include "api/perception/jpeg.h"
#include "fields/base/error.h"
#include "tests/api/ask/run/logged_runs.h"
#include "tests/api/door/dds/cdr_by_hand.h"
#include "tests/support/contains.h"

namespace slackwater::tests::seeing_run_test {
namespace {

const std::string yaml = R"(name: before a pile
seed: 11
origin: {latitude_deg: 54, longitude_deg: 6}
start: 2025-06-10T11:00:00Z
duration: 1min
step_s: 0.05
log_every_s: 0.5
water: {made_up: {depth_m: 30, current: [{depth_m: 0, east_m_s: 0.1, north_m_s: 0}]}}
waves:
  components: 24
  partitions: [{significant_height_m: 1, peak_period_s: 6, from_deg: 270}]
structures:
  - {name: pile, kind: cylinder, north_m: 0, east_m: 0, diameter_m: 6, top_height_m: 12,
     bottom_depth_m: 30}
vehicles:
  - name: rov 1
    model: bluerov2_heavy
    start: {north_m: -7, east_m: 0.5, depth_m: 8, heading_deg: 0}
    tasks: [{do: hold}]
  - name: uav
    model: x500
    start: {north_m: -20, east_m: 0, height_m: 10, heading_deg: 0}
    tasks: [{do: hold}]
)";

/// All messages of topics that begin so, as they come.
class Hearer final : public live::Outlet {
 public:
  explicit Hearer(std::string prefix) : prefix_(std::move(prefix)) {}
  void open(const bag::Channel& channel, live::Direction) override { channels_.push_back(channel); }
  [[nodiscard]] bool wants(std::size_t channel) const override {
    return channels_[channel].topic.starts_with(prefix_);
  }
  void publish(std::size_t channel, const dds::Stamp&, const dds::Bytes& message) override {
    heard_[channels_[channel].topic.substr(prefix_.size())].push_back(message);
  }
  /// Of a topic, by its name behind the prefix.
  [[nodiscard]] const std::vector<dds::Bytes>& heard(const std::string& topic) {
    return heard_[topic];
  }

 private:
  std::string prefix_;
  std::vector<bag::Channel> channels_;
  std::map<std::string, std::vector<dds::Bytes>> heard_;
};

/// s since the start of the run, of the header that comes next.
double time_of_header(HandReader& read, const std::string& frame_id) {
  const auto seconds = read.get<std::int32_t>();
  const auto nanoseconds = read.get<std::uint32_t>();
  EXPECT_EQ(read.string(), frame_id);
  const auto start = std::chrono::duration_cast<std::chrono::seconds>(
      parse_utc("2025-06-10T11:00:00Z").time_since_epoch());
  return static_cast<double>(seconds - start.count()) + 1e-9 * nanoseconds;
}

class SeeingRun : public LoggedRuns {
 protected:
  SeeingRun() : LoggedRuns(yaml) { scenario_.duration_s = 4; }

  struct Lived {
    std::filesystem::path log;
    std::vector<live::SensorTold> told;
    live::Punctuality punctuality{0};
    std::shared_ptr<Hearer> hearer;
  };
  Lived run_live(const std::vector<std::string>& sensors, double factor = 0,
                 const live::OnPicture& on_picture = {},
                 const std::function<void(const api::RunInHand&)>& also = {}) {
    live::LiveSettings settings;
    settings.real_time_factor = factor;
    settings.on_picture = on_picture;
    settings.on_trouble = [this](const std::string& text) { trouble_ += text + "\n"; };
    settings.see.sight = sight_;
    for (const std::string& text : sensors)
      settings.see.sensors.push_back(live::sensor_asked(text));
    Lived lived;
    lived.hearer = std::make_shared<Hearer>(
        settings.see.sensors.empty()
            ? "/none"
            : (settings.see.sensors[0].vehicle == "uav" ? "/uav/" : "/rov_1/") +
                  settings.see.sensors[0].sensor + "/");
    settings.outlets.push_back(lived.hearer);
    api::RunChoice choice;
    choice.real_time_factor = factor;
    std::unique_ptr<live::LiveRun> joined;
    choice.on_ready = [&](const api::RunInHand& hand) {
      if (also) also(hand);
      joined = std::make_unique<live::LiveRun>(hand, settings);
    };
    choice.on_over = [&] {
      if (!joined) return;
      lived.told = joined->end_sensors();
      lived.punctuality = joined->punctuality();
      joined.reset();
    };
    lived.log = make("run.nc", choice).log;
    return lived;
  }
  [[nodiscard]] static api::RenderChoice choice_of(const Lived& lived, const std::string& sensor,
                                                   const std::string& vehicle) {
    api::RenderChoice choice;
    choice.log = lived.log;
    choice.sensor = sensor;
    choice.vehicle = vehicle;
    return choice;
  }
  [[nodiscard]] api::RenderedRun afterwards(const Lived& lived, const std::string& sensor,
                                            const std::string& vehicle) const {
    return {choice_of(lived, sensor, vehicle), folder_.path() / "store"};
  }
  std::string refusal(const std::vector<std::string>& sensors) {
    try {
      (void)run_live(sensors);
    } catch (const Error& error) {
      return error.message();
    }
    return {};
  }
  std::string trouble_;
  api::SightChoice sight_;
};

void expect_all_accounted_for(const live::SensorTold& told, std::size_t heard) {
  EXPECT_EQ(told.made.looks, heard);
  EXPECT_EQ(told.made.moments, told.made.looks + told.made.dropped + told.made.unseen);
  EXPECT_GE(told.made.looks, 2U) << "the first one, and the last one that waits";
}

/// Also through water that somebody has made murky meanwhile.
TEST_F(SeeingRun, APictureIsToTheBitWhatTheLogShowsAfterwards) {
  twin::SetWeather murky;
  murky.asked.water_visibility_m = 3;
  murky.asked.over_s = 1;
  const Lived lived = run_live({"rov 1/rov_camera@2"}, 0, {}, [&](const api::RunInHand& hand) {
    twin::Command command;
    command.step = 7;
    command.what = murky;
    hand.run.enqueue(command);
  });
  const api::RenderedRun looking = afterwards(lived, "rov_camera", "rov 1");
  const auto& images = lived.hearer->heard("image/compressed");
  const auto& depths = lived.hearer->heard("depth");
  const auto& infos = lived.hearer->heard("camera_info");
  ASSERT_EQ(lived.told.size(), 1U);
  EXPECT_EQ(lived.told[0].made.moments, 9U) << "two a second from 0 to 4 s";
  expect_all_accounted_for(lived.told[0], images.size());
  ASSERT_EQ(depths.size(), images.size());
  ASSERT_EQ(infos.size(), images.size());
  EXPECT_EQ(lived.hearer->heard("pose").size(), images.size());
  double last_s = -1;
  for (std::size_t i = 0; i < images.size(); ++i) {
    HandReader read(images[i]);
    const double t_s = time_of_header(read, "rov_1/rov_camera");
    EXPECT_GT(t_s, last_s);
    last_s = t_s;
    const api::RenderView view = looking.view_at(t_s);
    const auto& camera = std::get<api::CameraView>(view.seen);
    EXPECT_EQ(read.string(), "jpeg");
    std::vector<std::uint8_t> jpeg(read.count());
    for (std::uint8_t& byte : jpeg) byte = read.octet();
    EXPECT_EQ(jpeg, api::jpeg_of(camera.picture)) << t_s;
    HandReader depth(depths[i]);
    EXPECT_EQ(time_of_header(depth, "rov_1/rov_camera"), t_s);
    EXPECT_EQ(depth.count(), 360U);
    EXPECT_EQ(depth.count(), 640U);
    EXPECT_EQ(depth.string(), "32FC1");
    (void)depth.octet();
    (void)depth.count();
    ASSERT_EQ(depth.count(), 640U * 360 * 4);
    std::size_t other = 0;
    for (const float expected : camera.truth.depth_m) {
      const float told = depth.real32();
      other += told == expected || (std::isnan(told) && std::isnan(expected)) ? 0 : 1;
    }
    EXPECT_EQ(other, 0U) << t_s;
  }
  EXPECT_EQ(last_s, 4);
}

/// What the operator of a session turns: the camera leaves what it is kept on.
TEST_F(SeeingRun, ACameraThatIsTurnedAndZoomedSeesWhatTheLogShowsAfterwards) {
  const auto turn = [](const api::RunInHand& hand) {
    twin::Command command;
    command.step = 21;  // 1.05 s
    command.what = twin::PointCamera{{0.3, -0.2, 2}};
    hand.run.enqueue(command);
    command.step = 61;
    command.what = twin::Resume{};
    hand.run.enqueue(command);
  };
  const Lived lived = run_live({"rov 1/rov_camera@2"}, 0, {}, turn);
  const api::RenderedRun looking = afterwards(lived, "rov_camera", "rov 1");
  const auto& images = lived.hearer->heard("image/compressed");
  for (const dds::Bytes& image : images) {
    HandReader read(image);
    const double t_s = time_of_header(read, "rov_1/rov_camera");
    (void)read.string();
    std::vector<std::uint8_t> jpeg(read.count());
    for (std::uint8_t& byte : jpeg) byte = read.octet();
    const auto view = looking.view_at(t_s);
    EXPECT_EQ(jpeg, api::jpeg_of(std::get<api::CameraView>(view.seen).picture)) << t_s;
  }
  const auto kept = looking.view_at(1), away = looking.view_at(2), again = looking.view_at(4);
  const auto& matrix_of = [](const api::RenderView& view) -> const std::array<double, 9>& {
    return std::get<api::CameraView>(view.seen).matrix;
  };
  EXPECT_NEAR(matrix_of(away)[0], 2 * matrix_of(kept)[0], 1e-6);
  EXPECT_EQ(matrix_of(again), matrix_of(kept));
  // Heading north with a little roll and pitch: 0.3 to the east of it, 0.2 down.
  EXPECT_NEAR(std::atan2(away.pose.axis.y, away.pose.axis.x), 0.3, 0.1);
  EXPECT_NEAR(std::asin(away.pose.axis.z), 0.2, 0.1);
  EXPECT_LT(std::abs(std::atan2(kept.pose.axis.y, kept.pose.axis.x)), 0.15);
}

/// All of a turn: what came back off the pile, and off the sea.
TEST_F(SeeingRun, PointsOfACloudLieOnWhatIsThere) {
  const Lived lived = run_live({"uav/uav_lidar@1"});
  const auto& clouds = lived.hearer->heard("points");
  const auto& poses = lived.hearer->heard("pose");
  expect_all_accounted_for(lived.told.at(0), clouds.size());
  ASSERT_EQ(poses.size(), clouds.size());
  const twin::LidarScan last =
      std::get<twin::LidarScan>(afterwards(lived, "uav_lidar", "uav").view_at(4).seen);
  HandReader at(poses.back());
  EXPECT_EQ(time_of_header(at, "map"), 4);
  const std::vector<double> from = at.reals(3), q = at.reals(4);  // east, north, up; x, y, z, w
  HandReader read(clouds.back());
  EXPECT_EQ(time_of_header(read, "uav/uav_lidar"), 4);
  ASSERT_EQ(read.count(), 64U);
  ASSERT_EQ(read.count(), 2048U);
  const std::uint32_t fields = read.count();
  for (std::uint32_t i = 0; i < fields; ++i) {
    (void)read.string();
    (void)read.count();
    (void)read.octet();
    (void)read.count();
  }
  (void)read.octet();
  (void)read.count();
  (void)read.count();
  ASSERT_EQ(read.count(), 64U * 2048 * 16);
  std::size_t on_pile = 0, off = 0;
  for (std::size_t i = 0; i < last.range_m.size(); ++i) {
    const twin::Triple<double> p{read.real32(), read.real32(), read.real32()};
    EXPECT_EQ(read.real32(), last.intensity[i]);
    ASSERT_EQ(std::isnan(p.x), std::isnan(last.range_m[i])) << i;
    if (std::isnan(p.x)) continue;
    EXPECT_NEAR(length_of(p), last.range_m[i], 1e-4);
    const twin::Triple<double> turned =
        twin::rotation_of(twin::Attitude<double>{q[3], q[0], q[1], q[2]}).to_ned(p);
    const double east = from[0] + turned.x, north = from[1] + turned.y, up = from[2] + turned.z;
    // Five standard deviations of 2 cm, the prism of 96 faces within 2 mm of the pile.
    constexpr double within_m = 0.102;
    if (std::abs(std::hypot(east, north) - 3) < within_m && up < 12 + within_m)
      ++on_pile;
    else if (std::abs(up) > 1.5)  // the sea, with waves of a metre, where it is heard at all
      ++off;
  }
  EXPECT_GT(on_pile, 500U);
  EXPECT_EQ(off, 0U);
}

TEST_F(SeeingRun, APingIsToTheBitWhatTheLogShowsAfterwards) {
  const Lived lived = run_live({"rov 1/imaging_sonar@2"});
  const auto& pings = lived.hearer->heard("sonar");
  expect_all_accounted_for(lived.told.at(0), pings.size());
  HandReader read(pings.back());
  const double t_s = time_of_header(read, "rov_1/imaging_sonar");
  const api::RenderedRun looking = afterwards(lived, "imaging_sonar", "rov 1");
  const auto image = std::get<twin::SonarImage>(looking.view_at(t_s).seen);
  EXPECT_EQ(read.real32(), 750e3F);
  EXPECT_EQ(read.real32(), 0);
  for (int widths = 0; widths < 2; ++widths) {
    const std::uint32_t beams = read.count();
    ASSERT_EQ(beams, 512U);
    for (std::uint32_t i = 0; i < beams; ++i) (void)read.real32();
  }
  ASSERT_EQ(read.count(), 512U);
  (void)read.reals(3 * 512);
  ASSERT_EQ(read.count(), 512U);
  for (int i = 0; i < 512; ++i) (void)read.real32();
  (void)read.octet();
  EXPECT_EQ(read.count(), 8U);
  EXPECT_EQ(read.count(), 512U);
  ASSERT_EQ(read.count(), 512U * 512 * 4);
  std::size_t other = 0;
  for (std::size_t bin = 0; bin < 512; ++bin)
    for (std::size_t beam = 0; beam < 512; ++beam)
      other += read.real32() == image.intensity[beam * 512 + bin] ? 0 : 1;
  EXPECT_EQ(other, 0U);
  read.expect_end();
}

/// A sonar that tells a line, a fan or one range, an ADCP, the right one of a pair: each by the
/// message that its view makes (tests/api/door/dds/sensor_bytes_test.cc has the bytes).
TEST_F(SeeingRun, EachSensorTellsWhatTheLogShowsAfterwards) {
  using namespace dds;
  using View = api::RenderView;
  using Message = std::function<Bytes(const View&, const twin::RenderSensor&, const SensorStamp&)>;
  struct Told {
    std::string vehicle, sensor, topic;
    Message message;
  };
  const Told all[] = {
      {"rov 1", "side_scan", "sonar",
       [](const View& view, const twin::RenderSensor& sensor, const SensorStamp& of) {
         return side_scan_image(std::get<twin::SideScanPing>(view.seen),
                                std::get<twin::SideScanSheet>(sensor.device), of);
       }},
      {"rov 1", "multibeam", "ranges",
       [](const View& view, const twin::RenderSensor& sensor, const SensorStamp& of) {
         return sonar_ranges(std::get<api::MultibeamView>(view.seen).soundings,
                             std::get<twin::MultibeamSheet>(sensor.device), of);
       }},
      {"rov 1", "echo_sounder", "range",
       [](const View& view, const twin::RenderSensor& sensor, const SensorStamp& of) {
         const auto& sounding = std::get<twin::EchoSounding>(view.seen);
         EXPECT_NEAR(sounding.range_m, 22, 1.5) << "30 m of water, 8 m down";
         return range_message(sounding, std::get<twin::EchoSounderSheet>(sensor.device), {0.3, 100},
                              of);
       }},
      {"rov 1", "adcp", "currents",
       [](const View& view, const twin::RenderSensor&, const SensorStamp& of) {
         return current_cloud(std::get<twin::CurrentProfile>(view.seen), of);
       }},
      {"rov 1", "rov_stereo", "right/image/compressed",
       [](const View& view, const twin::RenderSensor&, const SensorStamp& of) {
         return compressed_image(api::jpeg_of(std::get<api::CameraView>(view.seen).right->picture),
                                 of);
       }},
      {"uav", "uav_infrared", "temperature",
       [](const View& view, const twin::RenderSensor&, const SensorStamp& of) {
         return heat_image(std::get<api::InfraredView>(view.seen).heat, of);
       }}};
  for (const Told& told : all) {
    SCOPED_TRACE(told.sensor);
    const Lived lived = run_live({told.vehicle + "/" + told.sensor + "@1"});
    const auto& heard = lived.hearer->heard(told.topic);
    expect_all_accounted_for(lived.told.at(0), heard.size());
    const api::RenderedRun looking = afterwards(lived, told.sensor, told.vehicle);
    const Stamp at = stamp_of(parse_utc("2025-06-10T11:00:00Z"), 4);
    const std::string frame_id = (told.vehicle == "uav" ? "uav/" : "rov_1/") + told.sensor;
    EXPECT_EQ(heard.back(), told.message(looking.view_at(4), looking.sensor(), {at, frame_id}));
    EXPECT_EQ(lived.hearer->heard("pose").size(), heard.size());
  }
}

/// By night no sun: what is asked of light and heat is what is seen.
TEST_F(SeeingRun, LightAndHeatAreThoseThatAreAskedFor) {
  sight_ = {"oceanic_i", "winter_night", true};
  const Lived lived = run_live({"uav/uav_infrared@1"});
  api::RenderChoice choice = choice_of(lived, "uav_infrared", "uav");
  const auto heat_of = [&](const api::RenderChoice& chosen) {
    return dds::heat_image(
        std::get<api::InfraredView>(
            api::RenderedRun(chosen, folder_.path() / "store").view_at(4).seen)
            .heat,
        {dds::stamp_of(parse_utc("2025-06-10T11:00:00Z"), 4), "uav/uav_infrared"});
  };
  EXPECT_NE(lived.hearer->heard("temperature").back(), heat_of(choice));
  choice.sight = sight_;
  EXPECT_EQ(lived.hearer->heard("temperature").back(), heat_of(choice));
}

/// Whoever takes a picture away takes two seconds for it: longer than half of the run.
TEST_F(SeeingRun, GoesOnHoweverLongALookTakes) {
  std::size_t pictures = 0;
  const Lived lived = run_live({"rov 1/rov_camera@4"}, 1, [&](const live::SensorPicture& picture) {
    ++pictures;
    EXPECT_EQ(picture.vehicle, 0U);
    EXPECT_EQ(picture.wide, 640);
    EXPECT_GT(picture.jpeg->size(), 1000U);
    std::this_thread::sleep_for(std::chrono::seconds(2));
  });
  const live::LooksMade& made = lived.told.at(0).made;
  EXPECT_EQ(made.moments, 17U) << "four a second from 0 to 4 s";
  EXPECT_EQ(made.looks, pictures);
  EXPECT_EQ(made.dropped, 17 - pictures);
  EXPECT_LE(pictures, 4U);
  EXPECT_GT(made.mean_s(), 2);
  EXPECT_TRUE(contains(lived.told[0].text(), "rov 1/rov_camera at 4 Hz: 17 moments, "));
  EXPECT_TRUE(contains(lived.told[0].text(), "left out as the one before was not done"));
  EXPECT_EQ(lived.punctuality.steps(), 80U);
  EXPECT_LT(lived.punctuality.worst_s(), 1) << "no step waits for a look";
}

TEST_F(SeeingRun, NothingIsLookedAtThatNobodyHears) {
  // The hearer listens to the first of them.
  const Lived lived = run_live({"rov 1/imaging_sonar@1", "uav/uav_lidar@1", "rov 1/rov_camera@1"});
  EXPECT_EQ(lived.told.at(0).made.moments, 5U);
  EXPECT_EQ(lived.told.at(1).made.moments, 0U);
  EXPECT_EQ(lived.told.at(2).made.moments, 0U);
}

TEST_F(SeeingRun, WhatCannotBeIsOneClearErrorBeforeItBegins) {
  const std::pair<std::vector<std::string>, const char*> all[] = {
      {{"rov 2/rov_camera@2"},
       "--see rov 2/rov_camera: found no vehicle rov 2; the run has rov 1, uav"},
      {{"rov 1/rov_camra@2"}, "rov_camera"},
      {{"uav/rov_camera@2"}, "found it in air at"},
      {{"rov 1/uav_lidar@2"}, "found it under water at"},
      {{"rov 1/rov_camera@21"}, "found 21 Hz, expected at most 20 Hz: one each step of 0.05 s"},
      {{"rov 1/rov_camera@1", "rov 1/rov_camera@2"}, "found it twice"}};
  for (const auto& [sensors, says] : all) {
    EXPECT_TRUE(contains(refusal(sensors), says)) << says;
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "run.nc"));
  }
  EXPECT_EQ(run_live({"rov 1/rov_camera@20"}).told.size(), 1U) << "one each step";
}

/// An ROV that comes up is told of, once, and sees again when it is down again.
TEST_F(SeeingRun, OutsideOfItsMediumASensorIsToldAndWaits) {
  const Lived lived = run_live({"rov 1/rov_camera@2"}, 0, {}, [&](const api::RunInHand& hand) {
    // Held above the water from the first step on.
    twin::VehicleState<double> above = hand.run.states()[0].vehicle;
    above.body.position_m.z = -3;
    for (std::uint64_t step = 1; step < 80; ++step) {
      twin::Command command;
      command.step = step;
      command.what = twin::PutVehicle{above};
      hand.run.enqueue(command);
    }
  });
  const live::LooksMade& made = lived.told.at(0).made;
  EXPECT_GE(made.unseen, 1U);
  EXPECT_EQ(made.moments, made.looks + made.dropped + made.unseen);
  EXPECT_EQ(lived.hearer->heard("pose").size(), made.looks);
  const std::string once = "rov 1/rov_camera does not see for now: ";
  EXPECT_TRUE(contains(trouble_, once));
  EXPECT_EQ(trouble_.find(once), trouble_.rfind(once));
}

}  // namespace
}  // namespace slackwater::tests::seeing_run_test
