// What `forecast --print-downloads` tells people to fetch. Oracle: the published domains and masks
// of the products, cited in data/products.
#include "api/pipeline/fetch/download_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "ingest/cf/dataset_period.h"
#include "tests/support/contains.h"
#include "tests/support/shared_data.h"

namespace slackwater::api::downloads_test {
namespace {

using std::chrono::days;
using std::chrono::hours;
using tests::contains;

const ingest::ProductCatalogue& products() {
  static const auto catalogue =
      ingest::ProductCatalogue::load(tests::source_folder() / "data" / "products");
  return catalogue;
}

Site site_at(double latitude_deg, double longitude_deg) {
  Site site;
  site.id = site.name = "farm";
  site.point = GeoPoint::from_degrees(latitude_deg, longitude_deg);
  site.water_depth_m = 34;
  return site;
}

WantedTimes this_morning() {
  return {parse_day("2026-11-26"), parse_utc("2026-11-27T05:00:00Z"), hours(72)};
}

std::vector<std::string> lines_at(const Site& site, const WantedTimes& wanted = this_morning()) {
  return download_lines(products(), site, wanted);
}

/// The line that begins so and the one below it.
std::pair<std::string, std::string> told(const std::vector<std::string>& lines,
                                         const std::string& kind) {
  const auto comment = std::find_if(lines.begin(), lines.end(), [&](const std::string& line) {
    return line.starts_with("# " + kind + ": ");
  });
  if (comment == lines.end()) return {};
  const auto command = comment + 1;
  return {*comment, command == lines.end() ? "" : *command};
}

/// The product of a kind without its number, "NWSHELF", and "-" for none.
std::string family_of(const std::vector<std::string>& lines, const std::string& kind) {
  const std::string comment = told(lines, kind).first;
  if (contains(comment, "no Copernicus Marine dataset")) return "-";
  const std::size_t begin = comment.find(": ") + 2;
  return comment.substr(begin, comment.find('_') - begin);
}

struct PlaceAtSea {
  const char* name;
  double latitude_deg, longitude_deg;
  const char* currents;
  const char* level;
  const char* waves;
  const char* bathymetry;
};

/// Bounds and masks: product user manuals and catalogue as cited in data/products/*.yaml; which of
/// two that overlap: reference sheet of the products (North Sea and shelf NWS, Iberia IBI, Baltic
/// and Kattegat BAL). Where the tide has no level product, "-".
const PlaceAtSea places_at_sea[]{
    // The Atlantic side. The first three were told MEDSEA, whose box they lie in.
    {"Bilbao", 43.4, -3.1, "IBI", "IBI", "IBI", "IBI"},
    {"Arcachon", 44.6, -1.3, "IBI", "IBI", "IBI", "IBI"},
    {"Viana do Castelo", 41.7, -9.0, "IBI", "IBI", "IBI", "IBI"},
    {"La Coruna, Galicia", 43.5, -8.6, "IBI", "IBI", "IBI", "IBI"},
    {"Gulf of Cadiz", 36.5, -6.8, "IBI", "IBI", "IBI", "IBI"},
    {"Strait of Gibraltar", 35.95, -5.55, "IBI", "IBI", "IBI", "IBI"},
    {"Casablanca", 33.8, -7.8, "IBI", "IBI", "IBI", "IBI"},
    {"Madeira", 32.6, -16.8, "IBI", "IBI", "IBI", "IBI"},
    {"Gran Canaria", 27.8, -15.2, "IBI", "IBI", "IBI", "IBI"},
    // The shelf.
    {"Saint-Brieuc", 48.85, -2.55, "NWSHELF", "NWSHELF", "NWSHELF", "NWSHELF"},
    {"Irish Sea", 53.6, -3.8, "NWSHELF", "NWSHELF", "NWSHELF", "NWSHELF"},
    {"Dutch coast", 52.6, 4.4, "NWSHELF", "NWSHELF", "NWSHELF", "NWSHELF"},
    {"German Bight", 54.0, 6.6, "NWSHELF", "NWSHELF", "NWSHELF", "NWSHELF"},
    {"Skagerrak", 58.1, 9.6, "NWSHELF", "NWSHELF", "NWSHELF", "NWSHELF"},
    {"Norwegian coast, Stad", 62.1, 4.9, "NWSHELF", "NWSHELF", "NWSHELF", "NWSHELF"},
    // The Baltic.
    {"Kattegat, Anholt", 56.6, 11.2, "BALTICSEA", "-", "BALTICSEA", "BALTICSEA"},
    {"Kattegat, north of NWS's mask", 57.4, 11.2, "BALTICSEA", "-", "BALTICSEA", "BALTICSEA"},
    {"Fehmarn Belt", 54.6, 11.2, "BALTICSEA", "-", "BALTICSEA", "BALTICSEA"},
    {"Arkona", 54.9, 13.9, "BALTICSEA", "-", "BALTICSEA", "BALTICSEA"},
    {"Gdansk Bay", 54.6, 19.0, "BALTICSEA", "-", "BALTICSEA", "BALTICSEA"},
    {"Gulf of Finland", 59.8, 25.0, "BALTICSEA", "-", "BALTICSEA", "BALTICSEA"},
    {"Bothnian Sea, Gavle", 60.9, 17.5, "BALTICSEA", "-", "BALTICSEA", "BALTICSEA"},
    {"Bothnian Bay", 65.0, 23.0, "BALTICSEA", "-", "BALTICSEA", "BALTICSEA"},
    // The Mediterranean.
    {"Alboran Sea", 36.2, -3.5, "MEDSEA", "MEDSEA", "MEDSEA", "MEDSEA"},
    {"Gulf of Valencia", 39.6, 0.0, "MEDSEA", "MEDSEA", "MEDSEA", "MEDSEA"},
    {"Gulf of Lion, Gruissan", 43.0, 3.4, "MEDSEA", "MEDSEA", "MEDSEA", "MEDSEA"},
    {"Genoa", 44.2, 8.9, "MEDSEA", "MEDSEA", "MEDSEA", "MEDSEA"},
    {"Adriatic, Ravenna", 44.5, 12.6, "MEDSEA", "MEDSEA", "MEDSEA", "MEDSEA"},
    {"Gulf of Trieste", 45.6, 13.6, "MEDSEA", "MEDSEA", "MEDSEA", "MEDSEA"},
    {"Gulf of Sirte", 30.6, 19.0, "MEDSEA", "MEDSEA", "MEDSEA", "MEDSEA"},
    {"Aegean, Lemnos", 39.7, 25.6, "MEDSEA", "MEDSEA", "MEDSEA", "MEDSEA"},
    {"Gulf of Saros", 40.5, 26.4, "MEDSEA", "MEDSEA", "MEDSEA", "MEDSEA"},
    {"Alexandroupoli", 40.7, 25.8, "MEDSEA", "MEDSEA", "MEDSEA", "MEDSEA"},
    {"Mersin", 36.5, 34.3, "MEDSEA", "MEDSEA", "MEDSEA", "MEDSEA"},
    // The Black Sea, once told MEDSEA too; the Marmara has currents of its own and no waves.
    {"Varna", 43.1, 28.2, "BLKSEA", "BLKSEA", "BLKSEA", "BLKSEA"},
    {"Burgas", 42.5, 27.7, "BLKSEA", "BLKSEA", "BLKSEA", "BLKSEA"},
    {"South of the Crimea", 44.2, 33.5, "BLKSEA", "BLKSEA", "BLKSEA", "BLKSEA"},
    {"Off Sevastopol", 44.5, 33.0, "BLKSEA", "BLKSEA", "BLKSEA", "BLKSEA"},
    {"North of the Bosphorus", 41.4, 29.1, "BLKSEA", "BLKSEA", "BLKSEA", "BLKSEA"},
    {"Trabzon", 41.1, 39.8, "BLKSEA", "BLKSEA", "BLKSEA", "BLKSEA"},
    {"Sea of Azov", 46.2, 36.8, "BLKSEA", "BLKSEA", "BLKSEA", "BLKSEA"},
    {"Marmara Sea", 40.7, 28.2, "BLKSEA", "BLKSEA", "GLOBAL", "BLKSEA"},
    {"Dardanelles", 40.2, 26.4, "BLKSEA", "BLKSEA", "GLOBAL", "BLKSEA"},
    // Neither: the Norwegian Sea was told BALTICSEA, whose box it lies in.
    {"Norwegian coast, Trondelag", 64.6, 10.6, "GLOBAL", "-", "GLOBAL", "GLOBAL"},
    {"Lofoten", 68.0, 13.0, "GLOBAL", "-", "GLOBAL", "GLOBAL"},
    {"Iceland", 63.9, -22.9, "GLOBAL", "-", "GLOBAL", "GLOBAL"},
    {"Azores", 38.5, -28.3, "GLOBAL", "-", "GLOBAL", "GLOBAL"},
    {"Red Sea", 27.5, 34.2, "GLOBAL", "-", "GLOBAL", "GLOBAL"},
    {"Massachusetts", 41.0, -70.6, "GLOBAL", "-", "GLOBAL", "GLOBAL"},
    {"Bass Strait", -38.9, 147.0, "GLOBAL", "-", "GLOBAL", "GLOBAL"},
    {"Fiji, at the antimeridian", -17.0, 179.9, "GLOBAL", "-", "GLOBAL", "GLOBAL"},
};

TEST(Downloads, APlaceAtSeaGetsTheProductThatHasWaterThere) {
  for (const PlaceAtSea& place : places_at_sea) {
    SCOPED_TRACE(place.name);
    const auto lines = lines_at(site_at(place.latitude_deg, place.longitude_deg));
    EXPECT_EQ(family_of(lines, "currents"), place.currents);
    EXPECT_EQ(family_of(lines, "level"), place.level);
    EXPECT_EQ(family_of(lines, "waves"), place.waves);
    EXPECT_EQ(family_of(lines, "bathymetry"), place.bathymetry);
    EXPECT_EQ(family_of(lines, "wind"), "WIND");
  }
}

TEST(Downloads, AFileSaysByItsNameWhatItsStampsMean) {
  std::size_t means = 0;
  for (const PlaceAtSea& place : places_at_sea) {
    for (const std::string& line : lines_at(site_at(place.latitude_deg, place.longitude_deg))) {
      const std::size_t at = line.find("subset -i ");
      if (at == std::string::npos) continue;
      const std::string dataset = line.substr(at + 10, line.find(' ', at + 10) - at - 10);
      const std::string file = line.substr(line.find(" -f ") + 4);
      EXPECT_TRUE(contains(file, dataset)) << line;
      if (!dataset.ends_with("-m")) continue;
      ++means;
      const auto period = ingest::period_in(file);
      ASSERT_TRUE(period) << line;
      EXPECT_TRUE(period->is_mean) << line;
    }
  }
  EXPECT_GT(means, 40U);
}

TEST(Downloads, OfTwoModelsUnderOneNameTheOneOfTheSiteIsAskedFor) {
  const auto currents = [](double latitude_deg, double longitude_deg) {
    return told(lines_at(site_at(latitude_deg, longitude_deg)), "currents").second;
  };
  EXPECT_TRUE(contains(currents(43.1, 28.2), "-i cmems_mod_blk_phy-cur_anfc_2.5km_PT1H-m "));
  EXPECT_TRUE(contains(currents(40.7, 28.2), "-i cmems_mod_blk_phy-cur_anfc_mrm-500m_PT1H-i "));
}

TEST(Downloads, TheSeasOfAProductDoNotReachIntoThoseOfAnother) {
  // Every place at sea that a regional product claims for its currents belongs to it alone, but for
  // IBI, which comes after NWS and MEDSEA.
  const auto all = products().downloads();
  for (double latitude_deg = 26; latitude_deg < 67; latitude_deg += 0.37)
    for (double longitude_deg = -19.5; longitude_deg < 43; longitude_deg += 0.41) {
      const GeoPoint place = GeoPoint::from_degrees(latitude_deg, longitude_deg);
      const auto claims = std::count_if(all.begin(), all.end(), [&](const ingest::Download& d) {
        return d.kind == ingest::DownloadKind::current && d.priority == 10 && d.covers(place);
      });
      EXPECT_LE(claims, 1) << position_text(place);
    }
}

TEST(Downloads, AHistoryMovesTheBeginningOfAllThatHasTimesAndNothingElse) {
  const Site site = site_at(54.0, 6.6);
  WantedTimes wanted = this_morning();
  const auto lines = lines_at(site, wanted);
  wanted.history = days(60);
  const auto longer = lines_at(site, wanted);
  ASSERT_EQ(lines.size(), longer.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    // 26 November less 3 days, and less 60.
    const std::string moved = std::regex_replace(lines[i], std::regex(" -t 2026-11-23T00:00:00 "),
                                                 " -t 2026-09-27T00:00:00 ");
    EXPECT_EQ(longer[i], moved);
  }
  for (const char* kind : {"currents", "level", "waves", "wind"})
    EXPECT_TRUE(contains(told(longer, kind).second, " -t 2026-09-27T00:00:00 ")) << kind;
  EXPECT_FALSE(contains(told(longer, "bathymetry").second, " -t "));
}

TEST(Downloads, APastOfAnotherModelIsCutOffAndSaid) {
  // NWS was an extract of IBI until November 2025 (its product user manual).
  WantedTimes wanted = this_morning();
  wanted.history = days(500);
  const auto lines = lines_at(site_at(54.0, 6.6), wanted);
  const auto [comment, command] = told(lines, "currents");
  EXPECT_TRUE(contains(comment, "from 2025-12-01 (days before are of another model")) << comment;
  EXPECT_TRUE(contains(command, " -t 2025-12-01T00:00:00 ")) << command;
  EXPECT_TRUE(contains(told(lines, "wind").second, " -t 2025-07-14T00:00:00 "));
  EXPECT_TRUE(lines.front().starts_with("# currents")) << "no word about the archive";

  // A day of before is asked for all the same: who asks has a reason.
  wanted.day = parse_day("2025-03-08");
  wanted.history = days(3);
  EXPECT_TRUE(contains(told(lines_at(site_at(54.0, 6.6), wanted), "currents").second,
                       " -t 2025-03-05T00:00:00 "));
}

TEST(Downloads, APastBeyondTheArchiveIsTold) {
  WantedTimes wanted = this_morning();
  wanted.history = days(729);  // from two years before the day of issue on
  EXPECT_FALSE(contains(lines_at(site_at(43.4, -3.1), wanted).front(), "MULTIYEAR"));
  wanted.history = days(730);
  const std::string first = lines_at(site_at(43.4, -3.1), wanted).front();
  EXPECT_TRUE(first.starts_with("# before 2024-11-27: ")) << first;
  EXPECT_TRUE(contains(first, "MULTIYEAR")) << first;
}

std::string gfs_command(const std::string& issued, const std::string& until,
                        const Site& site = site_at(54.0, 6.6)) {
  const auto lines = gfs_wind_lines(site, parse_utc(issued), parse_utc(until));
  return lines.size() == 2 ? lines[1] : "none: " + lines.at(0);
}

TEST(GfsDownload, AsksForTheNewestRunPublishedAtTheIssue) {
  const auto run = [](const std::string& issued) {
    const std::string command = gfs_command(issued, "2026-11-30T00:00:00Z");
    std::smatch found;
    EXPECT_TRUE(std::regex_search(
        command, found,
        std::regex("dir=%2Fgfs\\.(\\d{8})%2F(\\d\\d)%2Fatmos&file=gfs\\.t(\\d\\d)z\\.")))
        << command;
    EXPECT_EQ(found[2], found[3]);
    return found[1].str() + found[2].str();
  };
  EXPECT_EQ(run("2026-11-27T05:00:00Z"), "2026112700");
  EXPECT_EQ(run("2026-11-27T04:59:59Z"), "2026112618");
  EXPECT_EQ(run("2026-11-27T10:59:00Z"), "2026112700");
  EXPECT_EQ(run("2026-11-27T11:00:00Z"), "2026112706");
  EXPECT_EQ(run("2026-11-27T23:30:00Z"), "2026112718");
}

TEST(GfsDownload, ItsStepsReachTheEndOfTheHorizon) {
  const auto steps = [](const std::string& issued, const std::string& until) {
    std::smatch found;
    const std::string command = gfs_command(issued, until);
    return std::regex_search(command, found, std::regex("seq -f %03g 0 3 (\\d+)\\)"))
               ? std::stoi(found[1])
               : -1;
  };
  EXPECT_EQ(steps("2026-11-27T05:00:00Z", "2026-11-30T00:00:00Z"), 72);
  EXPECT_EQ(steps("2026-11-27T04:00:00Z", "2026-11-30T00:00:00Z"), 78) << "of the run before";
  EXPECT_EQ(steps("2026-11-27T05:00:00Z", "2026-11-30T00:00:01Z"), 75);
  EXPECT_EQ(steps("2026-11-27T05:00:00Z", "2026-12-20T00:00:00Z"), 384) << "where the run ends";
  EXPECT_EQ(steps("2026-11-27T05:00:00Z", "2026-11-27T00:00:00Z"), -1) << "nothing is wanted";
}

TEST(GfsDownload, AsksForTenMetreWindAboutTheSiteInTheFormOfTheFilter) {
  const std::string command = gfs_command("2026-11-27T05:00:00Z", "2026-11-30T00:00:00Z");
  EXPECT_EQ(command,
            "mkdir -p downloads && (for h in $(seq -f %03g 0 3 72); do curl -fsS --retry 3 "
            "\"https://nomads.ncep.noaa.gov/cgi-bin/filter_gfs_0p25.pl?dir=%2Fgfs.20261127%2F00"
            "%2Fatmos&file=gfs.t00z.pgrb2.0p25.f$h&var_UGRD=on&var_VGRD=on"
            "&lev_10_m_above_ground=on&subregion=&leftlon=6.10&rightlon=7.10&toplat=54.50"
            "&bottomlat=53.50\" || exit 1; sleep 1; done) > downloads/farm_wind_forecast.grib2");
  // Across the antimeridian the box runs on past 180.
  const std::string across =
      gfs_command("2026-11-27T05:00:00Z", "2026-11-30T00:00:00Z", site_at(-17.0, 179.9));
  EXPECT_TRUE(contains(across, "leftlon=179.40&rightlon=180.40&")) << across;
}

}  // namespace
}  // namespace slackwater::api::downloads_test
