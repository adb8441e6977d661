// A log watched again: what a station is shown is what the log has, wherever its head is.
#include "api/door/people/playback/playback.h"

#include <gtest/gtest.h>

#include <numbers>

#include "api/door/people/playback/playback_routes.h"
#include "tests/api/door/people/playback/log_for_tests.h"
#include "tests/api/door/people/station_for_tests.h"
#include "tests/support/contains.h"
#include "tests/support/temporary_folder.h"
#include "tests/twin/run/run_for_tests.h"

namespace slackwater::tests::playback_test {
namespace {

using namespace std::chrono_literals;
using ingest::TrajectoryFile;
using nlohmann::json;
using people::Role;

/// A log that is served, and the log itself as the reader of the repository reads it.
struct Watched {
  explicit Watched(const TrajectoryFile& tracks) {
    ingest::write_trajectories(tracks, file);
    log = ingest::read_trajectories(file);
    playback =
        std::make_shared<people::Playback>(people::read_logged_run(file, source_folder() / "data"),
                                           people::find_surround(file, folder / "store", {}));
    api::http::Router router;
    people::add_routes(router, playback);
    api::http::ServerOptions options;
    options.read_only = true;
    server = std::make_unique<api::http::Server>(options, router);
    server->start();
  }
  ~Watched() { playback->end(); }
  [[nodiscard]] StationClient::AtLog at() const { return {server->port()}; }
  /// A number of a vehicle at a row of the log.
  [[nodiscard]] double logged(const char* name, std::size_t vehicle, std::size_t row,
                              std::size_t i = 0) const {
    const TrajectoryFile::Variable& v = *log.find(name);
    return v.values.at((vehicle * log.t_s.size() + row) * v.per + i);
  }

  TemporaryFolder folder;
  std::filesystem::path file = folder / "log.nc";
  TrajectoryFile log;
  std::shared_ptr<people::Playback> playback;
  std::unique_ptr<api::http::Server> server;
};

const slackwater::session::Frame* frame_in(const std::string& bytes) {
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  flatbuffers::Verifier verifier(data, bytes.size());
  EXPECT_TRUE(slackwater::session::VerifyFrameBuffer(verifier));
  return slackwater::session::GetFrame(data);
}

using Poses = std::map<int, slackwater::session::Pose>;

/// Goes there; where all vehicles are then, by the whole frame that comes of it.
Poses poses_at(StationClient& station, double time_s) {
  station.frames.clear();
  EXPECT_EQ(station.asks({{"do", "seek"}, {"time_s", time_s}})["taken"], true);
  Poses poses;
  for (int tries = 0; tries < 500; ++tries) {
    for (const std::string& bytes : station.frames) {
      const auto* frame = frame_in(bytes);
      if (frame->time_s() != time_s || !frame->is_whole()) continue;  // of before
      for (const auto* pose : *frame->poses()) poses.emplace(pose->vehicle(), *pose);
      return poses;
    }
    station.listen(10ms);
  }
  ADD_FAILURE() << "no whole frame of " << time_s << " s came";
  return poses;
}

struct Playback : testing::Test {
  Watched watched{made_up_log()};
  StationClient station{watched.at()};
  json welcome = station.hello("");
  /// Of the run's messages.
  static std::function<bool(const json&)> playing(bool is_playing) {
    return [=](const json& run) { return run["is_playing"] == is_playing; };
  }
  json asks(json message) { return station.asks(std::move(message)); }
};

TEST_F(Playback, WelcomesAnybodyAsASpectatorWithAllThatTheLogHas) {
  EXPECT_EQ(welcome["role"], "spectator");
  EXPECT_EQ(welcome["seat"], nullptr);
  EXPECT_EQ(welcome["seats"], json::array());
  EXPECT_EQ(welcome["playback"], json({{"from_s", 0.0}, {"to_s", 60.0}}));
  EXPECT_EQ(welcome["title"], "made up");
  EXPECT_EQ(welcome["start"], "2026-11-27T05:00:00Z");
  EXPECT_EQ(welcome["origin"]["lat"], 60.5);
  ASSERT_EQ(welcome["vehicles"].size(), 2U);
  EXPECT_EQ(welcome["vehicles"][1]["name"], "second");
  EXPECT_EQ(welcome["vehicles"][1]["length_m"], nullptr) << "its model is not told";
  EXPECT_EQ(welcome["actions"].size(), 5U);
  EXPECT_EQ(welcome["seen"], 1);
  EXPECT_EQ(welcome["run"]["state"], "recorded");
  EXPECT_EQ(welcome["run"]["is_playing"], false);
  EXPECT_FALSE(welcome.contains("resume"));
}

TEST_F(Playback, AtTheTimesOfTheLogShowsItsValues) {
  for (const std::size_t row : {0U, 7U, 25U, 60U}) {
    const Poses poses = poses_at(station, watched.log.t_s[row]);
    for (const auto& [place, pose] : poses) {
      const auto is = [&, vehicle = static_cast<std::size_t>(place)](float shown,
                                                                     const char* name) {
        EXPECT_EQ(shown, static_cast<float>(watched.logged(name, vehicle, row))) << name;
      };
      is(pose.east_m(), "x");
      is(pose.north_m(), "y");
      is(pose.up_m(), "z");
      is(pose.heading_rad(), "yaw");
      EXPECT_TRUE(std::isnan(pose.bed_m()) && std::isnan(pose.charge())) << "the log has neither";
    }
    EXPECT_EQ(poses.size(), row < 20 ? 1U : 2U);
  }
}

TEST_F(Playback, HalfwayBetweenTwoRowsShowsTheirMean) {
  const Poses poses = poses_at(station, 25.5);
  for (const auto& [place, pose] : poses) {
    const auto mean = [&, vehicle = static_cast<std::size_t>(place)](const char* name) {
      return 0.5 * (watched.logged(name, vehicle, 25) + watched.logged(name, vehicle, 26));
    };
    EXPECT_FLOAT_EQ(pose.east_m(), static_cast<float>(mean("x")));
    EXPECT_FLOAT_EQ(pose.north_m(), static_cast<float>(mean("y")));
    EXPECT_FLOAT_EQ(pose.up_m(), static_cast<float>(mean("z")));
  }
  EXPECT_EQ(poses.size(), 2U);
}

TEST_F(Playback, TurnsTheShortWayThroughNorth) {
  for (const auto& [time_s, degrees] : {std::pair(10.25, -0.5), {10.5, 0.0}, {10.75, 0.5}}) {
    const float heading_rad = poses_at(station, time_s).at(0).heading_rad();
    const double off =
        std::remainder(heading_rad - degrees * constants::degree, 2 * std::numbers::pi);
    EXPECT_NEAR(off, 0, 1e-6) << heading_rad;
  }
}

TEST_F(Playback, SoughtBackAndForthShowsTheSame) {
  const auto bytes = [](const Poses& poses) {
    std::string all;
    for (const auto& [vehicle, pose] : poses)
      all.append(reinterpret_cast<const char*>(&pose), sizeof pose);
    return all;
  };
  const std::string first = bytes(poses_at(station, 33.3)), other = bytes(poses_at(station, 5.1));
  EXPECT_NE(first, other);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(bytes(poses_at(station, 33.3)), first);
    EXPECT_EQ(bytes(poses_at(station, 5.1)), other);
  }
}

TEST_F(Playback, ShowsNobodyWhereTheLogHasNobody) {
  for (const double absent_s : {0.0, 19.0, 19.99, 39.5, 40.0, 44.0, 44.9})
    EXPECT_FALSE(poses_at(station, absent_s).contains(1)) << absent_s;
  for (const double there_s : {20.0, 20.5, 39.0, 45.0, 60.0})
    EXPECT_TRUE(poses_at(station, there_s).contains(1)) << there_s;
}

// The vehicle that goes out of the log while it plays is told by a whole frame without it.
TEST_F(Playback, LetsGoOfAVehicleThatIsNotThereAnyMore) {
  (void)poses_at(station, 38.8);
  station.frames.clear();
  (void)asks({{"do", "play"}, {"rate", 4}});
  bool is_let_go = false;
  for (int i = 0; i < 100 && !is_let_go; ++i) {
    station.listen(20ms);
    for (const std::string& bytes : station.frames) {
      const auto* frame = frame_in(bytes);
      const bool is_out = frame->time_s() > 39 && frame->time_s() < 45;
      is_let_go = is_let_go || (is_out && frame->is_whole() && frame->poses()->size() == 1);
    }
  }
  EXPECT_TRUE(is_let_go);
}

TEST_F(Playback, TellsTheActionsOfTheLogAsItsHeadPassesThem) {
  (void)asks({{"do", "play"}, {"rate", 100}});
  EXPECT_FALSE(station.told("run", playing(false)).is_null());
  std::vector<json> told;
  for (json message : station.messages)
    if (message["is"] == "action") {
      message.erase("is");
      told.push_back(message);
    }
  const std::vector<json> rows(welcome["actions"].begin() + 1, welcome["actions"].end());
  EXPECT_EQ(told, rows) << "the first one was before its head, the last one after the last row";
  const auto logged = api::actions_in(watched.log);
  ASSERT_EQ(logged.size(), welcome["actions"].size());
  for (std::size_t i = 0; i < logged.size(); ++i)
    EXPECT_EQ(welcome["actions"][i]["what"], logged[i].what);
}

TEST_F(Playback, SaysAfterASeekWhichActionsWereBefore) {
  const auto seen = [&](double time_s) {
    (void)asks({{"do", "seek"}, {"time_s", time_s}});
    for (auto message = station.messages.rbegin();; ++message)
      if ((*message)["is"] == "seen") return (*message)["number"].get<int>();
  };
  EXPECT_EQ(seen(12.4), 1);
  EXPECT_EQ(seen(12.5), 3);
  EXPECT_EQ(seen(60), 5);
  EXPECT_EQ(seen(0), 1);
}

TEST_F(Playback, GoesAtTheRateThatIsAskedFor) {
  (void)asks({{"do", "seek"}, {"time_s", 5}});
  const auto began = std::chrono::steady_clock::now();
  (void)asks({{"do", "play"}, {"rate", 10}});
  station.listen(1000ms);
  station.says({{"do", "pause"}});
  const json stopped = station.told("run", playing(false));
  const double took_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  ASSERT_FALSE(stopped.is_null());
  EXPECT_NEAR(stopped["time_s"].get<double>() - 5, 10 * took_s, 2 * took_s);
  EXPECT_EQ(stopped["rate"], 10);
  // Paused it stays where it is.
  station.frames.clear();
  station.listen(300ms);
  EXPECT_TRUE(station.frames.empty());
}

TEST_F(Playback, ShowsTwentyFramesASecondAndNotMore) {
  (void)asks({{"do", "play"}, {"rate", 1}});
  station.frames.clear();
  station.listen(2000ms);
  EXPECT_GE(station.frames.size(), 25U) << "on a machine that is busy";
  EXPECT_LE(station.frames.size(), 42U);
}

TEST_F(Playback, StopsAtItsEndSaysSoAndBeginsAgainWhenItIsPlayed) {
  (void)asks({{"do", "seek"}, {"time_s", 59.5}});
  (void)asks({{"do", "play"}});
  const json stopped = station.told("run", playing(false));
  EXPECT_EQ(stopped["state"], "recorded");
  EXPECT_EQ(stopped["time_s"], 60.0);
  station.frames.clear();
  (void)asks({{"do", "play"}});
  station.listen(200ms);
  ASSERT_FALSE(station.frames.empty());
  EXPECT_LT(frame_in(station.frames.back())->time_s(), 5);
}

TEST_F(Playback, GivesEachStationAHeadOfItsOwn) {
  StationClient other{watched.at()};
  EXPECT_TRUE(other.hello("Bob").is_object());
  const Poses here = poses_at(station, 10), there = poses_at(other, 50);
  EXPECT_FLOAT_EQ(here.at(0).east_m(), 3.7F);
  EXPECT_FLOAT_EQ(there.at(0).east_m(), 18.5F);
  (void)other.asks({{"do", "play"}, {"rate", 100}});
  station.frames.clear();
  station.listen(300ms);
  EXPECT_TRUE(station.frames.empty()) << "this one is paused";
  EXPECT_FALSE(other.told("run", playing(false)).is_null()) << "the other one comes to its end";
}

TEST_F(Playback, TellsHelmAndStatusAsOfItsHead) {
  const auto last = [&](const std::string& is) {
    for (auto message = station.messages.rbegin(); message != station.messages.rend(); ++message)
      if ((*message)["is"] == is && (*message)["vehicle"] == 0) return *message;
    return json();
  };
  EXPECT_EQ(welcome["helms"][0]["holder"], "Ann");
  EXPECT_EQ(welcome["helms"][1]["state"], "free");
  (void)asks({{"do", "seek"}, {"time_s", 20}});
  EXPECT_EQ(last("helm")["state"], "requested");
  EXPECT_EQ(last("helm")["asker"], "Sue");
  (void)asks({{"do", "seek"}, {"time_s", 55}});
  EXPECT_EQ(last("helm")["holder"], "Sue");
  EXPECT_EQ(last("status")["halt"], "aground");
  EXPECT_EQ(last("status")["doing"], "halted");
  (void)asks({{"do", "seek"}, {"time_s", 1}});
  EXPECT_EQ(last("helm")["holder"], "Ann");
  EXPECT_EQ(last("status")["halt"], "none");
}

TEST_F(Playback, RefusesWhatItCannotReadAndGoesOn) {
  const std::vector<std::pair<json, std::string>> wrong{
      {{{"do", "play"}, {"rate", 0}}, "play: rate: found 0, expected a number from 0.1 to 100"},
      {{{"do", "play"}, {"rate", "fast"}}, "expected a number"},
      {{{"do", "play"}, {"rate", 1e9}}, "expected a number"},
      {{{"do", "seek"}}, "seek: found no time_s"},
      {{{"do", "seek"}, {"time_s", nullptr}}, "seek: time_s: found null"},
      {{{"do", "hello"}, {"name", "again"}}, "a second one"},
      {{{"do", "stick"}, {"vehicle", 0}}, "nothing to do to a recording"},
      {{{"do", "saw"}, {"frame", 4000000}}, "never sent"}};
  for (const auto& [message, words] : wrong) {
    const json answer = asks(message);
    EXPECT_EQ(answer["taken"], false) << message;
    EXPECT_TRUE(contains(answer.value("text", ""), words)) << answer;
  }
  EXPECT_EQ(asks({{"do", "seek"}, {"time_s", -1e9}})["taken"], true) << "to the nearest time";
  EXPECT_EQ(poses_at(station, 0).size(), 1U);
  station.says_text("no JSON");
  EXPECT_EQ(station.closed(), 4004);
}

TEST_F(Playback, TurnsOutWhoSaysNoHelloFirst) {
  StationClient rude{watched.at()};
  rude.says({{"do", "play"}});
  EXPECT_EQ(rude.closed(), 4004);
}

TEST_F(Playback, LetsInNoPageOfAnotherOriginOrHost) {
  EXPECT_EQ(StationClient(watched.at(), "Origin: http://example.org\r\n").status(), 403);
  HttpClient client(watched.server->port());
  const auto list = client.get("/sessions");
  ASSERT_TRUE(list);
  EXPECT_EQ(json::parse(list->body)["sessions"][0]["state"], "recorded");
  EXPECT_EQ(client.get("/sessions/log/check")->status, 204);
  EXPECT_EQ(json::parse(client.get("/sessions/log/actions")->body)["actions"].size(), 5U);
  HttpClient stranger(watched.server->port());
  ASSERT_TRUE(stranger.send(
      "GET /sessions/log/actions HTTP/1.1\r\nHost: example.org\r\nConnection: close\r\n\r\n"));
  EXPECT_EQ(stranger.receive()->status, 403) << "a name that was made to mean this machine";
}

// --- a real session ---

/// Ann drives, Sue lets a vehicle join, and the log is read as it was written.
TEST(PlaybackOfASession, ShowsItAsItWas) {
  const std::string yaml =
      calm_head(0.05) +
      "  - {name: rov 1, model: bluerov2_heavy, start: {north_m: 5, east_m: 2, depth_m: 10}, "
      "tasks: [{do: hold}]}\nstructures:\n  - {kind: cylinder, north_m: 0, east_m: 20, "
      "diameter_m: 10, top_height_m: 10, bottom_depth_m: 60}\n";
  SessionUnderWay run{yaml};
  StationClient ann{run, run.token(Role::drives)}, sue{run, run.token(Role::supervises)};
  const json live = ann.hello("Ann");
  (void)sue.hello("Sue");
  EXPECT_EQ(ann.asks({{"do", "ask"}, {"vehicle", 0}})["taken"], true);
  for (int i = 0; i < 20; ++i)
    EXPECT_EQ(ann.asks(ann.command("stick", 0, {{"velocity", {0.4, 0, 0, 0.2}}}))["taken"], true);
  const json joins = sue.asks({{"do", "spawn"},
                               {"model", "bluerov2_heavy"},
                               {"name", "late"},
                               {"east_m", -9},
                               {"north_m", 4},
                               {"up_m", -6},
                               {"heading_deg", 90}});
  ASSERT_EQ(joins["taken"], true) << joins;
  EXPECT_FALSE(ann.told("vehicle").is_null());
  ann.listen(2500ms);
  const TrajectoryFile& file = run.ended().file;
  Watched watched(file);
  StationClient station{watched.at()};
  const json welcome = station.hello("");
  EXPECT_EQ(welcome["vehicles"][0], live["vehicles"][0]) << "as it was told live";
  EXPECT_EQ(welcome["structures"], live["structures"]);
  EXPECT_EQ(welcome["step_s"], live["step_s"]);
  ASSERT_EQ(welcome["vehicles"].size(), 2U);
  EXPECT_EQ(welcome["vehicles"][1]["model"], "bluerov2_heavy");
  const std::size_t rows = watched.log.t_s.size();
  bool was_absent = false;
  for (std::size_t row = 0; row < rows; ++row) {
    const Poses poses = poses_at(station, watched.log.t_s[row]);
    const auto is = [&](float shown, const char* name, std::size_t vehicle, std::size_t i = 0) {
      EXPECT_EQ(shown, static_cast<float>(watched.logged(name, vehicle, row, i))) << name;
    };
    const bool is_there = std::isfinite(watched.logged("x", 1, row));
    EXPECT_EQ(poses.contains(1), is_there);
    was_absent = was_absent || !is_there;
    for (const auto& [vehicle, pose] : poses) {
      const auto place = static_cast<std::size_t>(vehicle);
      is(pose.east_m(), "x", place);
      is(pose.up_m(), "z", place);
      is(pose.roll_rad(), "roll", place);
      is(pose.pitch_rad(), "pitch", place);
      is(pose.heading_rad(), "yaw", place);
      is(pose.charge(), "state_of_charge", place);
      is(pose.current_east_m_s(), "water_velocity", place, 0);
      is(pose.current_north_m_s(), "water_velocity", place, 1);
      const double ahead_m_s = std::hypot(watched.logged("velocity_body", place, row, 0),
                                          watched.logged("velocity_body", place, row, 1),
                                          watched.logged("velocity_body", place, row, 2));
      EXPECT_NEAR(std::hypot(pose.east_m_s(), pose.north_m_s(), pose.up_m_s()), ahead_m_s, 1e-6);
    }
  }
  EXPECT_TRUE(was_absent && poses_at(station, watched.log.t_s.back()).contains(1));
  // The sticks ended of themselves.
  const auto helm_at = [&](double time_s) {
    (void)station.asks({{"do", "seek"}, {"time_s", time_s}});
    json last = welcome["helms"][0];
    for (const json& message : station.messages)
      if (message["is"] == "helm" && message["vehicle"] == 0) last = message;
    return last;
  };
  EXPECT_EQ(helm_at(watched.log.t_s.back())["cause"], "not_renewed");
  EXPECT_EQ(helm_at(watched.log.t_s.back())["holder"], "Ann");
}

}  // namespace
}  // namespace slackwater::tests::playback_test
