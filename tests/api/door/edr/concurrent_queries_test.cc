// Many ask while forecasts are swapped: each answer is of one piece.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <string>
#include <thread>

#include "tests/api/door/edr/edr_service_for_tests.h"
#include "tests/api/door/edr/made_up_store.h"

namespace slackwater::tests::concurrent_queries_test {
namespace {

constexpr std::size_t clients = 8;
constexpr int swaps = 12;

/// The made-up forecast with one current everywhere, which tells the day of
/// its issue: 0.01 m/s a day.
Snapshot marked(int days_later) {
  Snapshot made = lone_forecast(days_later, 7);
  for (ForecastColumn& column : made.columns)
    column.current_m_s.assign(column.current_m_s.size(), Horizontal(0.01 * days_later, 0));
  return made;
}

/// What stands between `before` and `after` in a text; "" where they are not there.
std::string between(const std::string& text, const std::string& before, const std::string& after) {
  const std::size_t at = text.find(before);
  if (at == std::string::npos) return {};
  const std::size_t start = at + before.size();
  return text.substr(start, text.find(after, start) - start);
}

/// Whether an answer's values are those of the forecast that it names.
bool is_of_one_piece(const std::string& body) {
  const std::string issued = between(body, "\"issued\":\"", "\"");
  const std::string value = between(body, "\"values\":[0.", "]");
  if (issued.size() < 10 || value.empty()) return false;
  const int day = std::atoi(issued.substr(8, 2).c_str());
  return std::abs(std::atof(("0." + value).c_str()) - 0.01 * (day - 10)) < 1e-6;
}

QueryPairs at_depth(const char* depth) {
  return {{"coords", "POINT(-2.55 48.85)"},
          {"z", depth},
          {"parameter-name", "eastward_sea_water_velocity"}};
}

TEST(ConcurrentQueries, AreEachOfOnePieceWhileForecastsAreSwapped) {
  EdrServiceForTests service;
  service.issue(marked(2));
  std::atomic<bool> done{false};
  std::atomic<long> answers{0};
  std::atomic<int> faults{0};
  std::vector<std::thread> threads;
  for (std::size_t c = 0; c < clients; ++c) {
    threads.emplace_back([&, c] {
      constexpr std::array depths{"1", "5", "20"};
      for (std::size_t n = 0; !done.load(); ++n) {
        QueryPairs query = at_depth(depths.at((n + c) % depths.size()));
        const auto answer = service.get("/collections/currents/position", query);
        const bool is_right = answer.status == 200 && is_of_one_piece(answer.body);
        if (!is_right && faults++ == 0) ADD_FAILURE() << answer.body.substr(0, 600);
        // Some ask for older ones too, which are read from their files, and for what there is.
        if (c == 0)
          faults += service.get("/collections/currents/instances/" +
                                    std::string(EdrServiceForTests::older) + "/position",
                                query)
                                .status == 200
                        ? 0
                        : 1;
        if (c == 1) faults += service.get("/collections/currents/items").status == 200 ? 0 : 1;
        if (c == 2) {
          query.emplace_back("f", "NetCDF");
          faults += service.get("/collections/currents/position", query).status == 200 ? 0 : 1;
        }
        ++answers;
      }
    });
  }
  for (int swap = 3; swap < 3 + swaps; ++swap) service.issue(marked(swap));
  while (answers.load() < 400) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  done = true;
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(faults.load(), 0) << "of " << answers.load() << " answers";
}

}  // namespace
}  // namespace slackwater::tests::concurrent_queries_test
