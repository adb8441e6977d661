// What is about the vehicles of a log that is watched again: the sea and the weather of its run, as
// they were told while it went on; and what is said where they are gone.
#include <gtest/gtest.h>

#include <map>
#include <mutex>
#include <set>

#include "api/door/people/playback/playback_routes.h"
#include "api/door/people/told.h"
#include "data/store/store.h"
#include "ingest/cf/forecast/forecast_file.h"
#include "tests/api/door/people/station_for_tests.h"
#include "tests/support/contains.h"
#include "tests/support/error_of.h"
#include "tests/support/made_up_forecast.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::playback_around_test {
namespace {

using namespace std::chrono_literals;
using ingest::TrajectoryFile;
using nlohmann::json;
using people::Role;

/// An ROV in waves, current and a light wind, and two vessels that pass.
std::string run_in(const std::string& water, const std::string& waves) {
  return "name: led\nseed: 7\nduration: 30min\nstep_s: 0.05\nlog_every_s: 0.5\nwater: " + water +
         "\nwaves: " + waves + R"(
vehicles:
  - {name: rov, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: 10},
     tasks: [{do: hold}]}
traffic:
  alarm: {cpa_m: 200, tcpa_min: 5}
  vessels:
    - {mmsi: 211000001, name: COASTER, speed_m_s: 8,
       waypoints: [{north_m: 100, east_m: -900}, {north_m: 100, east_m: 20000}]}
    - {mmsi: 211000002, name: FERRY, speed_m_s: 9,
       waypoints: [{north_m: 700, east_m: 900}, {north_m: 700, east_m: -20000}]}
)";
}
const std::string stated_waves =
    "{components: 16, partitions: [{significant_height_m: 0.5, peak_period_s: 6, from_deg: 200}]}";
const std::string made_up =
    "{made_up: {depth_m: 40, current: [{depth_m: 0, east_m_s: 0.1, north_m_s: 0}, "
    "{depth_m: 30, east_m_s: 0, north_m_s: 0.1}], wind: {speed_m_s: 4, from_deg: 200}}}";

/// A run that went on with people, what it told of the weather at each tenth of a second, and its
/// log.
struct Live {
  struct Told {
    json weather, traffic;
  };
  json welcome;
  std::map<double, Told> told;
  TrajectoryFile log;
  double led_s = 0;  ///< when somebody had asked for other weather

  explicit Live(const std::string& yaml) {
    std::mutex mutex;
    SessionUnderWay::Choice choice;
    choice.real_time_factor = 4;
    choice.also = [&](const api::RunInHand& hand) {
      hand.run.at_barrier([this, hand, &mutex](const twin::StepTime&) {
        if (hand.run.steps_made() % 2 != 0) return;
        const double t_s = hand.run.time_s();
        std::vector<Horizontal> places_m;
        for (const twin::Seen& seen : hand.run.seen())
          places_m.emplace_back(seen.position_m.y, seen.position_m.x);
        const people::Surroundings around =
            people::surroundings_of(people::run_place(hand), t_s, places_m);
        const std::lock_guard lock(mutex);
        told[t_s] = {people::weather_json(around, t_s, {}, ""), people::traffic_json(around)};
      });
    };
    SessionUnderWay run(yaml, choice);
    StationClient sue(run, run.token(Role::supervises));
    welcome = sue.hello("Sue");
    sue.listen(500ms);
    expect_taken(sue.asks({{"do", "weather"},
                           {"wind", {{"speed_m_s", 12}, {"from_deg", 270}}},
                           {"waves_m", 1.2},
                           {"current", {{"speed_m_s", 0.4}, {"to_deg", 90}}},
                           {"water_visibility_m", 1.5},
                           {"over_s", 4}}));
    sue.listen(2s);
    expect_taken(sue.asks({{"do", "weather"}, {"waves_m", 0.2}, {"over_s", 3}}));
    sue.listen(1500ms);
    log = run.ended().file;
  }
};

struct Watched {
  explicit Watched(const TrajectoryFile& tracks,
                   const std::optional<std::filesystem::path>& forecast = {},
                   const std::filesystem::path& store = {}) {
    ingest::write_trajectories(tracks, file);
    found = people::find_surround(file, store, forecast);
    missing = found.missing;
    playback = std::make_shared<people::Playback>(
        people::read_logged_run(file, source_folder() / "data"), std::move(found));
    api::http::Router router;
    people::add_routes(router, playback);
    api::http::ServerOptions options;
    options.read_only = true;
    server = std::make_unique<api::http::Server>(options, router);
    server->start();
    station = std::make_unique<StationClient>(StationClient::AtLog{server->port()});
    welcome = station->hello("");
  }
  ~Watched() { playback->end(); }
  /// Goes there; what was told last of it by then.
  json at(double time_s, const std::string& is) {
    EXPECT_EQ(station->asks({{"do", "seek"}, {"time_s", time_s}})["taken"], true);
    for (auto told = station->messages.rbegin(); told != station->messages.rend(); ++told)
      if ((*told)["is"] == is) return *told;
    return welcome[is];
  }

  TemporaryFolder folder;
  std::filesystem::path file = folder / "log.nc";
  people::FoundSurround found;
  std::string missing;
  std::shared_ptr<people::Playback> playback;
  std::unique_ptr<api::http::Server> server;
  std::unique_ptr<StationClient> station;
  json welcome;
};

constexpr const char* facts[] = {"sea",    "water",    "turbines", "bed",
                                 "cables", "moorings", "origin",   "start"};

/// The run in made-up water, made once for all tests.
const Live& live_in_made_up() {
  static const Live live(run_in(made_up, stated_waves));
  return live;
}

/// @param least  weathers that it had
void expect_as_told(const Live& live, Watched& watched, std::size_t least) {
  EXPECT_EQ(watched.missing, "");
  for (const char* const fact : facts) EXPECT_EQ(watched.welcome[fact], live.welcome[fact]) << fact;
  EXPECT_EQ(watched.welcome["sea"]["waves"].size(), 16U);
  std::set<std::string> weathers;
  const auto compare = [&](const auto& told) {
    const auto& [t_s, is] = told;
    if (t_s > watched.welcome["playback"]["to_s"]) return;
    json weather = watched.at(t_s, "weather");
    if (!weather["led"].empty()) EXPECT_EQ(weather["led_by"], "Sue");
    weather["led_by"] = nullptr;
    EXPECT_EQ(weather, is.weather) << t_s << " s";
    EXPECT_EQ(watched.at(t_s, "traffic"), is.traffic) << t_s << " s";
    weathers.insert(is.weather.dump());
  };
  // On, and back.
  std::size_t looked = 0;
  for (auto told = live.told.begin(); told != live.told.end(); ++told)
    if (++looked % 5 == 0) compare(*told);
  for (auto told = live.told.rbegin(); told != live.told.rend(); ++told)
    if (++looked % 11 == 0) compare(*told);
  EXPECT_GT(weathers.size(), least) << "it was led, and settled";
}

TEST(PlaybackAround, IsTheSeaAndTheWeatherThatTheLiveRunTold) {
  const Live& live = live_in_made_up();
  Watched watched(live.log);
  expect_as_told(live, watched, 10);
  ASSERT_FALSE(live.told.empty());
  EXPECT_EQ(live.told.begin()->second.traffic["vessels"].size(), 2U);
}

TEST(PlaybackAround, OfARunInAForecastIsByItsFileAndElseSaidToBeGone) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "forecast.nc";
  const Snapshot forecast = made_up_forecast({1, 6, 12, 1, 3});
  ingest::write_forecast(file, forecast);
  const std::string water =
      "{forecast: {file: " + file.string() + "}}\nstart: " + format_utc(forecast.time.at(2));
  const Live live(run_in(water, "{from: forecast, components: 16}"));
  EXPECT_TRUE(live.welcome["water"]["forecast"].is_string());
  Watched watched(live.log, file);
  expect_as_told(live, watched, 10);
  (void)store::Store::open(folder / "store", store::OpenMode::create_or_write);
  EXPECT_TRUE(contains(Watched(live.log, {}, folder / "store").missing, "is not in the store"));
  // Another file is not taken for it, and not passed over either.
  const std::filesystem::path other = folder / "other.nc";
  ingest::write_forecast(other, made_up_forecast({1, 6, 12, 1, 4}));
  ingest::write_trajectories(live.log, folder / "log.nc");
  const auto find_with_another = [&] {
    (void)people::find_surround(folder / "log.nc", folder / "store", other);
  };
  EXPECT_TRUE(contains(error_of(find_with_another), "is not the forecast of this log"));
}

TEST(PlaybackAround, IsToldOnceASecondOfTheHeadAsItPlays) {
  const Live& live = live_in_made_up();
  Watched watched(live.log);
  const double lasts_s = watched.welcome["playback"]["to_s"];
  ASSERT_GT(lasts_s, 8);
  watched.station->messages.clear();
  EXPECT_EQ(watched.station->asks({{"do", "play"}, {"rate", 4}})["taken"], true);
  EXPECT_FALSE(
      watched.station->told("run", [](const json& run) { return run["is_playing"] == false; })
          .is_null());
  std::size_t told = 0;
  json last;
  for (const json& message : watched.station->messages)
    if (message["is"] == "traffic") {
      ++told;
      last = message;
    }
  EXPECT_GE(static_cast<double>(told), 0.5 * lasts_s) << "vessels go on";
  EXPECT_LE(static_cast<double>(told), lasts_s + 2);
  const auto at_end = live.told.lower_bound(lasts_s - 1e-6);
  ASSERT_NE(at_end, live.told.end());
  EXPECT_EQ(last, at_end->second.traffic) << "at its end";
}

TEST(PlaybackAround, SaysWhyItIsNotKnownAndHasTheSunAllTheSame) {
  TrajectoryFile log = live_in_made_up().log;
  for (auto& [name, value] : log.attributes)
    if (name == "forecast_sha256") value = std::string(64, '0');
  if (log.attribute("forecast_sha256").empty())
    log.attributes.emplace_back("forecast_sha256", std::string(64, '0'));
  const TemporaryFolder folder;
  (void)store::Store::open(folder / "store", store::OpenMode::create_or_write);
  Watched watched(log, {}, folder / "store");
  EXPECT_TRUE(contains(watched.missing, "the forecast that the log ran in (checksum 0000"))
      << watched.missing;
  EXPECT_EQ(watched.welcome["water"], json({{"missing", watched.missing}}));
  EXPECT_EQ(watched.welcome["sea"], nullptr);
  EXPECT_EQ(watched.welcome["turbines"], nullptr);
  EXPECT_EQ(watched.welcome["traffic"], nullptr);
  const json weather = watched.at(3, "weather");
  EXPECT_EQ(weather["wind_m_s"], nullptr);
  EXPECT_EQ(weather["waves_m"], nullptr);
  EXPECT_TRUE(weather["currents"].empty());
  EXPECT_TRUE(weather["sun"]["elevation_deg"].is_number());
}

TEST(PlaybackAround, OfALogWithoutAScenarioIsNotKnown) {
  TrajectoryFile log = live_in_made_up().log;
  std::erase_if(log.attributes, [](const auto& it) { return it.first == "scenario"; });
  const Watched watched(log);
  EXPECT_TRUE(contains(watched.missing, "holds no scenario")) << watched.missing;
  EXPECT_EQ(watched.welcome["water"], json({{"missing", watched.missing}}));
}

}  // namespace
}  // namespace slackwater::tests::playback_around_test
