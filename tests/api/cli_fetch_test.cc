// `slackwater fetch` against programs that behave as those of the providers do, fault by fault:
// asked too often, no login, not out yet, a page in the place of data, half a file, yesterday's
// file, another sea, one that hangs, none installed, killed in the middle.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "api/made_up/synthetic/product_files.h"
#include "tests/support/contains.h"
#include "tests/support/shared_data.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_fetch_test {
namespace {

using nlohmann::json;
using std::chrono::days;

/// Takes the first line of $here/KIND, and does what it says; without one, what is right. A file of
/// Copernicus Marine comes from good/KIND, a step of the wind from good/wind_forecast.
constexpr const char* fake_toolbox = R"(#!/bin/sh
here=$(dirname "$0")
for argument in "$@"; do
  case "$argument" in
    --output-directory=*) folder=${argument#*=};;
    --output-filename=*) file=${argument#*=};;
  esac
done
kind=$(echo "$file" | sed 's/^[^_]*_//; s/_cmems.*//')
echo "$kind $*" >> "$here/calls"
echo "$COPERNICUSMARINE_SERVICE_PASSWORD" >> "$here/passwords"
does=$(head -n 1 "$here/plan_$kind" 2>/dev/null)
sed -i 1d "$here/plan_$kind" 2>/dev/null
good="$here/good/$kind"
target="$folder/$file"
case "$does" in
  busy)
    echo 'Client error: An error occurred (429) when calling HeadObject: Too Many Requests'
    exit 1;;
  login_down)
    echo 'credentials_utils.CouldNotConnectToAuthenticationSystem' >&2
    exit 1;;
  no_login)
    echo "InvalidUsernameOrPassword: not accepted: $COPERNICUSMARINE_SERVICE_PASSWORD" >&2
    exit 1;;
  updating)
    echo 'WARNING: the dataset is currently being updated'
    echo 'DatasetUpdating' >&2
    exit 1;;
  page) printf '<!DOCTYPE html><html><body>Sign in</body></html>' > "$target";;
  half) head -c 3000 "$good" > "$target";;
  empty) : > "$target";;
  yesterday) cp "$here/good/old_currents" "$target";;
  elsewhere) cp "$here/good/far_currents" "$target";;
  waves) cp "$here/good/waves" "$target";;
  hangs) sleep 100;;
  dies) kill -9 $$;;
  lies) exit 0;;
  odd) echo 'Traceback: something nobody has met'; exit 3;;
  slow) sleep 1; cp "$good" "$target";;
  *) cp "$good" "$target";;
esac
)";
constexpr const char* fake_curl = R"(#!/bin/sh
here=$(dirname "$0")
while [ $# -gt 1 ]; do [ "$1" = --output ] && target=$2; shift; done
echo "$1" >> "$here/steps"
does=$(head -n 1 "$here/plan_wind_forecast" 2>/dev/null)
sed -i 1d "$here/plan_wind_forecast" 2>/dev/null
case "$does" in
  not_out) echo 'curl: (22) The requested URL returned error: 404' >&2; exit 22;;
  down) echo 'curl: (22) The requested URL returned error: 503' >&2; exit 22;;
esac
step=$(echo "$1" | sed 's/.*[.]f\([0-9]*\)&.*/\1/')
[ "$does" = empty ] && : > "$target" || cp "$here/good/step_$step" "$target"
)";

constexpr const char* at = "2025-03-10T05:30:00Z";  // D is the 9th

class Fetch : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    made_ = new TemporaryFolder;
    const std::filesystem::path folder = *made_ / "made";
    std::filesystem::create_directories(folder);
    const UtcDay day = parse_day("2025-03-09");
    api::SyntheticOceanSettings settings;
    settings.first_day = day - days(4);
    settings.days = 11;
    const api::SyntheticOcean ocean(settings);
    const auto currents = api::write_current_product(ocean, day - days(3), day + days(4), folder);
    const auto named = [&](const char* part) {
      return *std::find_if(currents.begin(), currents.end(), [&](const auto& file) {
        return contains(file.filename().string(), part);
      });
    };
    const std::filesystem::path good = *made_ / "good";
    std::filesystem::create_directories(good);
    const auto keep = [&](const std::filesystem::path& from, const char* kind) {
      std::filesystem::copy_file(from, good / kind);
    };
    keep(named("phy-cur"), "currents");
    keep(named("phy-ssh"), "level");
    keep(api::write_wave_product(ocean, day - days(3), day + days(4), folder), "waves");
    keep(api::write_bathymetry(ocean, folder), "bathymetry");
    keep(api::write_wind_analysis(ocean, day - days(3), day, folder), "wind");
    keep(api::write_wind_forecast(ocean, parse_utc("2025-03-10T00:00:00Z"), 96, folder),
         "wind_forecast");
    split_by_step(good / "wind_forecast", good);
    const std::filesystem::path old = *made_ / "old";
    std::filesystem::create_directories(old);
    for (const auto& file : api::write_current_product(ocean, day - days(4), day - days(4), old))
      if (contains(file.filename().string(), "phy-cur")) keep(file, "old_currents");
    settings.site = GeoPoint::from_degrees(54, 6.5);
    const std::filesystem::path far = *made_ / "far";
    std::filesystem::create_directories(far);
    for (const auto& file :
         api::write_current_product(api::SyntheticOcean(settings), day, day, far))
      if (contains(file.filename().string(), "phy-cur")) keep(file, "far_currents");
    api::write_site_yaml(ocean, *made_ / "site");
  }
  /// Its messages, in their order, as the 25 files of the steps from 0 to 72 h.
  static void split_by_step(const std::filesystem::path& grib, const std::filesystem::path& into) {
    const std::string bytes = read_bytes(grib);
    std::vector<std::string> messages;
    for (std::size_t at = 0; at + 16 <= bytes.size();) {
      std::size_t length = 0;  // GRIB 2: of all of it, in octets 9 to 16
      for (std::size_t i = 8; i < 16; ++i)
        length = length << 8U | static_cast<unsigned char>(bytes[at + i]);
      messages.push_back(bytes.substr(at, length));
      at += length;
    }
    constexpr std::size_t steps = 25;
    for (std::size_t step = 0; step < steps; ++step) {
      const std::string hours = std::to_string(3 * step);
      std::ofstream out(into / ("step_" + std::string(3 - hours.size(), '0') + hours),
                        std::ios::binary);
      for (std::size_t i = step * messages.size() / steps; i < (step + 1) * messages.size() / steps;
           ++i)
        out << messages[i];
    }
  }
  static void TearDownTestSuite() { delete made_; }

  Fetch() {
    bin_ = store_.file("bin");
    std::filesystem::create_directories(bin_);
    std::filesystem::create_directory_symlink(*made_ / "good", bin_ / "good");
    install("copernicusmarine", fake_toolbox);
    install("curl", fake_curl);
    // As they are, but that they do not wait.
    const std::filesystem::path own = store_.file("config/slackwater/fetchers");
    std::filesystem::create_directories(own);
    for (const char* id : {"copernicusmarine", "gfs"}) {
      std::string yaml =
          read_bytes(source_folder() / "data/fetchers" / (std::string(id) + ".yaml"));
      for (const char* key : {"first_wait_s: ", "between_s: ", "longest_s: "}) {
        const std::size_t from = yaml.find(key);
        if (from == std::string::npos) continue;
        const std::size_t value = from + std::string(key).size();
        const std::size_t end = yaml.find_first_of(" \n", value);
        yaml.replace(value, end - value, std::string(key) == "longest_s: " ? "2" : "0.01");
      }
      std::ofstream(own / (std::string(id) + ".yaml")) << yaml;
    }
  }

  void install(const std::string& name, const char* script) const {
    std::ofstream(bin_ / name) << script;
    std::filesystem::permissions(bin_ / name, std::filesystem::perms::owner_all);
  }
  void plan(const std::string& kind, const std::string& does) const {
    std::ofstream(bin_ / ("plan_" + kind)) << does;
  }
  [[nodiscard]] std::map<std::string, std::string> environment() const {
    return {{"PATH", bin_.string() + ":/usr/bin:/bin"},
            {"XDG_CONFIG_HOME", store_.path("config")},
            {"COPERNICUSMARINE_SERVICE_PASSWORD", "open-sesame-77"}};
  }
  [[nodiscard]] std::vector<std::string> command(std::vector<std::string> more = {}) const {
    std::vector<std::string> all{
        "--store", store_.store().string(), "fetch", "--site", site_file().string(), "--at", at,
        "--into",  store_.path("downloads")};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  [[nodiscard]] static std::filesystem::path site_file() {
    for (const auto& entry : std::filesystem::directory_iterator(*made_ / "site"))
      return entry.path();
    return {};
  }
  [[nodiscard]] ProgramResult fetch(const std::vector<std::string>& more = {}) const {
    return run_program(command(more), environment());
  }
  [[nodiscard]] json fetched(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all{"--json"};
    all.insert(all.end(), more.begin(), more.end());
    const ProgramResult run = fetch(all);
    json files;
    const json out = json::parse(run.out, nullptr, false);
    EXPECT_FALSE(out.is_discarded()) << run.out << run.err;
    for (const json& file : out.at("files")) files[file.at("kind").get<std::string>()] = file;
    files["exit"] = run.exit_code;
    files["err"] = run.err;
    return files;
  }
  /// Lines that the toolbox was called with, of a kind.
  [[nodiscard]] std::vector<std::string> calls(const std::string& kind) const {
    std::vector<std::string> found;
    std::ifstream lines(bin_ / "calls");
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with(kind + " ")) found.push_back(line);
    return found;
  }

  static inline const TemporaryFolder* made_ = nullptr;
  StoreForTests store_;
  std::filesystem::path bin_;
};

TEST_F(Fetch, BringsAllThatAForecastWantsAndTheStoreTakesIt) {
  const json files = fetched();
  EXPECT_EQ(files.at("exit"), 0) << files.dump(2);
  for (const char* kind : {"currents", "level", "waves", "bathymetry", "wind", "wind forecast"}) {
    EXPECT_EQ(files.at(kind).at("state"), "fetched") << files.at(kind).dump(2);
    EXPECT_EQ(files.at(kind).at("tries"), 1);
  }
  const std::vector<std::string> currents = calls("currents");
  ASSERT_EQ(currents.size(), 1U);
  for (const char* argument :
       {" subset ", "--dataset-id=cmems_mod_nws_phy-cur_anfc_1.5km-3D_PT1H-i", "--variable=uo ",
        "--variable=vo ", "--start-datetime=2025-03-06T00:00:00 ",
        "--end-datetime=2025-03-13T00:00:00 ", "--maximum-depth=", "--raise-if-updating"})
    EXPECT_TRUE(contains(currents[0], argument)) << argument << "\n" << currents[0];
  EXPECT_FALSE(contains(currents[0], "--dataset-part"));
  EXPECT_TRUE(contains(calls("bathymetry").at(0), "--dataset-part=bathy"));
  EXPECT_FALSE(contains(calls("bathymetry").at(0), "--start-datetime"));
  EXPECT_EQ(store_.run({"ingest", store_.path("downloads"), "--at", at}).exit_code, 0);
}

TEST_F(Fetch, FetchesNothingAgainUntilThereIsANewerIssue) {
  EXPECT_EQ(fetch().exit_code, 0);
  const std::size_t before = calls("currents").size();
  const json again = fetched();
  EXPECT_EQ(again.at("currents").at("state"), "here");
  EXPECT_EQ(again.at("wind forecast").at("state"), "here");
  EXPECT_EQ(calls("currents").size(), before);
  // What changed on the disk is not what was fetched.
  std::ofstream(again.at("currents").at("file").get<std::string>(), std::ios::app) << "x";
  EXPECT_EQ(fetched().at("currents").at("state"), "fetched");
}

TEST_F(Fetch, TriesAgainWhereThatHelps) {
  plan("currents", "busy\nbusy\n");
  plan("waves", "login_down\nodd\n");
  plan("wind_forecast", "down\nempty\n");
  const json files = fetched();
  EXPECT_EQ(files.at("exit"), 0) << files.dump(2);
  EXPECT_EQ(files.at("currents").at("tries"), 3);
  EXPECT_EQ(files.at("waves").at("tries"), 3);
  EXPECT_EQ(files.at("wind forecast").at("tries"), 3);
}

TEST_F(Fetch, DoesNotTryAgainWhereThatHelpsNobody) {
  plan("currents", "no_login\n");
  const json files = fetched();
  EXPECT_EQ(files.at("exit"), 5);
  EXPECT_EQ(files.at("currents").at("tries"), 1);
  EXPECT_EQ(files.at("currents").at("state"), "failed");
  EXPECT_EQ(files.at("waves").at("state"), "fetched") << "the others go on";
  EXPECT_TRUE(contains(files.at("err").get<std::string>(), "1 of 6 files did not come: currents"))
      << files.at("err");
}

TEST_F(Fetch, TellsNoPassword) {
  plan("currents", "no_login\n");
  const ProgramResult run = fetch();
  EXPECT_FALSE(contains(run.out + run.err, "open-sesame-77")) << run.out << run.err;
  EXPECT_TRUE(contains(run.out, "not accepted: ***")) << run.out;
  EXPECT_TRUE(contains(read_bytes(bin_ / "passwords"), "open-sesame-77")) << "it was given it";
  for (const std::string& call : calls("currents"))
    EXPECT_FALSE(contains(call, "open-sesame-77")) << "and not on its command line";
}

TEST_F(Fetch, TakesNoFileThatIsNotWhatWasAskedFor) {
  for (const auto& [does, why] :
       std::map<std::string, std::string>{{"page", "a page of text in the place of data"},
                                          {"half", "currents"},
                                          {"empty", "an empty file"},
                                          {"yesterday", "it is of another day"},
                                          {"elsewhere", "it is of another place"},
                                          {"waves", "expected eastward_sea_water_velocity"},
                                          {"lies", "no file"}}) {
    SCOPED_TRACE(does);
    std::string always;
    for (int i = 0; i < 5; ++i) always += does + "\n";
    plan("currents", always);
    const json files = fetched();
    EXPECT_EQ(files.at("exit"), 5);
    EXPECT_EQ(files.at("currents").at("state"), "failed");
    EXPECT_EQ(files.at("currents").at("tries"), 5);
    const std::string said = files.at("currents").at("why").get<std::string>();
    EXPECT_TRUE(contains(said, why)) << said;
    EXPECT_TRUE(files.at("currents").at("file").is_null()) << "nothing of it is kept";
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(store_.file("downloads")))
      EXPECT_FALSE(contains(entry.path().filename().string(), "currents")) << entry.path();
  }
  EXPECT_EQ(fetched().at("currents").at("state"), "fetched") << "and then the right one";
}

TEST_F(Fetch, KeepsAnOlderFileWhereANewerOneFails) {
  EXPECT_EQ(fetch().exit_code, 0);
  plan("currents", "no_login\n");
  const ProgramResult run =
      run_program({"--store", store_.store().string(), "fetch", "--site", site_file().string(),
                   "--at", "2025-03-10T15:30:00Z", "--into", store_.path("downloads"), "--json"},
                  environment());
  const json out = json::parse(run.out);
  const json currents = out.at("files").at(0);
  EXPECT_EQ(currents.at("state"), "failed");
  EXPECT_TRUE(contains(currents.at("why").get<std::string>(),
                       "that of 2025-03-10T05:30:00Z is still there"))
      << currents.dump(2);
  EXPECT_TRUE(std::filesystem::exists(currents.at("file").get<std::string>()));
}

TEST_F(Fetch, SaysWhatIsNotOutYetAndWhenItWillBe) {
  plan("currents", "updating\n");
  plan("wind_forecast", "\n\nnot_out\n");
  const json files = fetched();
  EXPECT_EQ(files.at("exit"), 5) << "late, and no older one is there";
  EXPECT_EQ(files.at("currents").at("state"), "late");
  EXPECT_EQ(files.at("currents").at("tries"), 1);
  EXPECT_FALSE(files.at("currents").at("next_out").is_null());
  EXPECT_EQ(files.at("wind forecast").at("state"), "late");
  EXPECT_TRUE(contains(files.at("wind forecast").at("why").get<std::string>(), "step 3 of"));
  const std::string steps = read_bytes(bin_ / "steps");
  const auto asked_before = std::count(steps.begin(), steps.end(), '\n');
  EXPECT_EQ(asked_before, 3);
  // The steps that came are not asked for again.
  const json again = fetched();
  EXPECT_EQ(again.at("wind forecast").at("state"), "fetched") << again.dump(2);
  const std::string all = read_bytes(bin_ / "steps");
  EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), asked_before + 25 - 2);
}

/// ECMWF's package by another one of its name: its own server is down, a mirror has the run.
TEST_F(Fetch, AsksAnotherModelWhereTheFirstIsNotOut) {
  plan("wind_forecast", "not_out\n");
  const std::filesystem::path package = store_.file("python/ecmwf/opendata");
  std::filesystem::create_directories(package);
  std::ofstream(package / "__init__.py") << R"(
import shutil
from datetime import datetime
class Client:
    def __init__(self, source):
        self.source = source
    def latest(self, **request):
        if self.source == "ecmwf":
            raise RuntimeError("503 Server Error: Service Unavailable")
        assert request["step"] % 3 == 0 and request["type"] == "fc"
        return datetime(2025, 3, 10)
    def retrieve(self, date, time, type, step, param, target):
        assert (date, time, type, param) == ("2025-03-10", 0, "fc", ["10u", "10v"])
        assert step == list(range(0, 73, 3)), step
        shutil.copy(")" << (bin_ / "good/wind_forecast").string()
                                         << "\", target)\n";
  std::string yaml = read_bytes(source_folder() / "data/fetchers/ecmwf.yaml");
  yaml.replace(yaml.find("{here}"), 6, (source_folder() / "data/fetchers").string());
  yaml.replace(yaml.find("[HOME,"), 6, "[PYTHONPATH, HOME,");
  std::ofstream(store_.file("config/slackwater/fetchers/ecmwf.yaml")) << yaml;
  std::map<std::string, std::string> with_package = environment();
  with_package["PYTHONPATH"] = store_.path("python");
  const ProgramResult run = run_program(command({"--json"}), with_package);
  const json wind = json::parse(run.out).at("files").at(5);
  EXPECT_EQ(wind.at("state"), "fetched") << wind.dump(2);
  EXPECT_EQ(wind.at("by"), "ecmwf");
}

TEST_F(Fetch, EndsWhatHangsAndWhatDies) {
  plan("currents", "hangs\n");
  plan("waves", "dies\n");
  const auto began = std::chrono::steady_clock::now();
  const json files = fetched();
  EXPECT_EQ(files.at("exit"), 0) << files.dump(2);
  EXPECT_EQ(files.at("currents").at("tries"), 2);
  EXPECT_EQ(files.at("waves").at("tries"), 2);
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(60));
}

/// A history that nobody has taken in yet is not overwritten by a shorter one.
TEST_F(Fetch, PutsALongerHistoryAside) {
  EXPECT_EQ(fetch({"--history", "20d"}).exit_code, 0);
  EXPECT_EQ(fetch().exit_code, 0);
  std::size_t currents = 0;
  for (const auto& entry : std::filesystem::directory_iterator(store_.file("downloads")))
    currents +=
        entry.path().extension() == ".nc" && contains(entry.path().filename().string(), "currents");
  EXPECT_EQ(currents, 2U);
}

TEST_F(Fetch, IsOfUseForASiteThatWasOnlyJustNamed) {
  std::filesystem::create_directories(store_.store() / "sites");
  EXPECT_EQ(fetched({"--dry-run"}).at("exit"), 0);
}

TEST_F(Fetch, SaysThatTheProgramIsNotInstalled) {
  std::filesystem::remove(bin_ / "copernicusmarine");
  const json files = fetched();
  EXPECT_EQ(files.at("exit"), 5);
  EXPECT_TRUE(contains(files.at("currents").at("why").get<std::string>(), "not installed"));
  EXPECT_EQ(files.at("wind forecast").at("state"), "fetched");
}

TEST_F(Fetch, GoesOnWhereItWasKilled) {
  plan("waves", "slow\nslow\n");
  const pid_t program = start_program(command(), environment());
  for (int i = 0; i < 200 && calls("waves").empty(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  ASSERT_FALSE(calls("waves").empty());
  kill(program, SIGKILL);
  wait_for_program(program);
  const json files = fetched();
  EXPECT_EQ(files.at("exit"), 0) << files.dump(2);
  EXPECT_EQ(files.at("currents").at("state"), "here");
  EXPECT_EQ(files.at("waves").at("state"), "fetched");
}

TEST_F(Fetch, IsOneAtATimeInAFolder) {
  plan("currents", "slow\n");
  const pid_t program = start_program(command(), environment());
  for (int i = 0; i < 200 && calls("currents").empty(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  const ProgramResult second = fetch();
  EXPECT_EQ(second.exit_code, 5);
  EXPECT_TRUE(contains(second.err, "another process at work in it")) << second.err;
  EXPECT_EQ(wait_for_program(program), 0);
}

TEST_F(Fetch, SaysWhatItWouldDoAndDoesNothing) {
  const json files = fetched({"--dry-run"});
  EXPECT_EQ(files.at("exit"), 0);
  EXPECT_EQ(files.at("currents").at("why"), "would be fetched");
  EXPECT_TRUE(calls("currents").empty());
  EXPECT_FALSE(std::filesystem::exists(store_.file("downloads")));
}

TEST_F(Fetch, LeavesOutOfTheHistoryWhatIsStored) {
  store_.ingest_days(parse_day("2025-03-06"), 7);
  const auto currents_from = [&](const std::string& history) {
    const ProgramResult run =
        run_program({"--store", store_.store().string(), "fetch", "--site", store_.site(), "--at",
                     "2025-03-13T05:30:00Z", "--dry-run", "--json", "--history", history},
                    environment());
    return json::parse(run.out).at("files").at(0).at("from").get<std::string>();
  };
  // Day D is the 12th. The 6th to the 8th are stored; the last three days before D are asked for
  // again.
  EXPECT_EQ(currents_from("6d"), "2025-03-09T00:00:00Z");
  // Nothing of before the 6th is stored: from the beginning.
  EXPECT_EQ(currents_from("20d"), "2025-02-20T00:00:00Z");
}

TEST_F(Fetch, RefusesAFetcherThatItDoesNotUnderstand) {
  std::ofstream(store_.file("config/slackwater/fetchers/gfs.yaml"))
      << "id: gfs\nserves: [wind forecast]\nprogram: curl\narguments: [\"{adress}\"]\n";
  const ProgramResult run = fetch();
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_TRUE(contains(run.err, "gfs.yaml:4: arguments: found {adress}, expected one of {address}"))
      << run.err;
}

}  // namespace
}  // namespace slackwater::tests::cli_fetch_test
