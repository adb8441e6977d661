// The pages of `serve` as a person walks them: from the first page on, every link.
#include <gtest/gtest.h>
#include <signal.h>

#include <deque>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <thread>

#include "tests/api/door/edr/made_up_store.h"
#include "tests/support/http_client.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::serve_pages_test {
namespace {

using namespace std::chrono_literals;

/// `slackwater serve` over made-up forecasts: one with waves and wind, one without.
class ServePages : public ::testing::Test {
 protected:
  ServePages() {
    fill_with_made_up_forecasts(folder_ / "store");
    Snapshot bare = lone_forecast(0, 5);
    bare.site_id = "bare";
    bare.site_name = "Bare <b>";
    bare.columns.front().point = GeoPoint::from_degrees(50, -4);
    for (ForecastColumn& column : bare.columns) {
      column.wind_m_s.clear();
      column.wind_source.clear();
      column.wind_member_m_s.clear();
      column.sea.clear();
      column.sea_source.clear();
      column.water_depth_m = 6;
      for (std::size_t i = 0; i < column.current_status.size(); ++i)
        if (bare.depth_m[i % bare.depth_m.size()] > 6)
          column.current_status[i] = SampleStatus::below_bed;
    }
    commit_made_up_forecast(folder_ / "store", bare);
    program_ = start_program({"--store", (folder_ / "store").string(), "--json", "serve", "--port",
                              "0", "--stale-after", "2d"},
                             {}, folder_ / "address");
    for (int i = 0; i < 200 && port_ == 0; ++i) {
      std::this_thread::sleep_for(50ms);
      std::ifstream file(folder_ / "address");
      const auto said = nlohmann::json::parse(file, nullptr, false);
      if (said.is_object()) port_ = said.at("port").get<std::uint16_t>();
    }
  }
  ~ServePages() override {
    ::kill(program_, SIGTERM);
    static_cast<void>(wait_for_program(program_));
  }
  ServePages(const ServePages&) = delete;
  ServePages& operator=(const ServePages&) = delete;

  [[nodiscard]] HttpReply get(const std::string& target) const {
    const auto reply = HttpClient(port_).get(target);
    return reply ? *reply : HttpReply{};
  }

  TemporaryFolder folder_;
  pid_t program_ = 0;
  std::uint16_t port_ = 0;
};

std::string unescaped(std::string text) {
  for (std::size_t at = text.find("&amp;"); at != std::string::npos; at = text.find("&amp;", at))
    text.replace(at++, 5, "&");
  return text;
}

/// Addresses of a page's links.
std::vector<std::string> links_of(const std::string& html) {
  static const std::regex form("<a href=\"([^\"]*)\"");
  std::vector<std::string> links;
  for (std::sregex_iterator found(html.begin(), html.end(), form), end; found != end; ++found)
    links.push_back(unescaped((*found)[1]));
  return links;
}

TEST_F(ServePages, EveryLinkOfEveryPageIsAnswered) {
  ASSERT_NE(port_, 0);
  // The client names the host "localhost" or an address: links are as it was asked.
  const std::regex own("https?://[^/]*(/.*)");
  std::deque<std::string> open{"/?f=html"};
  std::set<std::string> seen{open.front()};
  std::size_t pages = 0;
  while (!open.empty() && seen.size() < 2000) {
    const std::string target = open.front();
    open.pop_front();
    const HttpReply reply = get(target);
    EXPECT_EQ(reply.status, 200) << target << ": " << reply.body.substr(0, 300);
    if (!reply.field("content-type").starts_with("text/html")) continue;
    ++pages;
    EXPECT_NE(reply.body.find("<meta name=\"viewport\" content=\"width=device-width"),
              std::string::npos)
        << target;
    EXPECT_EQ(reply.body.find("<b>"), std::string::npos) << target;
    EXPECT_NE(reply.body.find("/\">The desk</a>"), std::string::npos) << target;
    EXPECT_EQ(reply.field("content-security-policy").find("default-src 'none'"), 0U) << target;
    for (const std::string& link : links_of(reply.body)) {
      std::smatch parts;
      const bool is_own = std::regex_match(link, parts, own) || link.starts_with("/");
      EXPECT_TRUE(is_own) << target << " leads to " << link;
      const std::string path = parts.empty() ? link : parts[1].str();
      if (seen.insert(path).second) open.push_back(path);
    }
  }
  // Five collections, each with its instances, items and locations, the front page and the rest.
  EXPECT_GT(pages, 60U);
  EXPECT_LT(seen.size(), 2000U);
}

TEST_F(ServePages, TheFrontPageListsTheSitesAndHowOldTheirForecastsAre) {
  const std::string page = get("/?f=html").body;
  for (const char* words : {"Site lone", "Site farm", "Bare &lt;b&gt;", "stale", "Issued ",
                            " days ago", "2025-03-11T05:00:00Z", "See why the daily job"})
    EXPECT_NE(page.find(words), std::string::npos) << words;
  const auto sites = nlohmann::json::parse(get("/").body).at("slackwater:sites");
  ASSERT_EQ(sites.size(), 4U);
  EXPECT_EQ(sites[3].at("id"), "lone");
  EXPECT_EQ(sites[3].at("issued"), "2025-03-11T05:00:00Z");
  EXPECT_GT(sites[3].at("age_s").get<double>(), 86400);
}

TEST_F(ServePages, HealthAndMetricsTellTheAgeOfEverySite) {
  const HttpReply health = get("/health");
  EXPECT_EQ(health.status, 200);
  EXPECT_EQ(nlohmann::json::parse(health.body).at("status"), "stale");
  EXPECT_EQ(nlohmann::json::parse(health.body).at("stale_after_s"), 2 * 86400);
  EXPECT_EQ(get("/health/fresh").status, 503);
  const std::string metrics = get("/metrics").body;
  for (const char* site : {"bare", "dateline", "farm", "lone"}) {
    const std::string line =
        std::string("\nslackwater_forecast_age_seconds{site=\"") + site + "\"} ";
    ASSERT_NE(metrics.find(line), std::string::npos) << metrics;
    EXPECT_GT(std::stod(metrics.substr(metrics.find(line) + line.size())), 1e6) << site;
  }
}

}  // namespace
}  // namespace slackwater::tests::serve_pages_test
