// Many read, one swaps.
#include "fields/service/published.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace slackwater::published_test {
namespace {

/// A value that shows whether it was seen whole and alive.
struct Whole {
  explicit Whole(int n) { part.fill(n); }
  ~Whole() { part.fill(-1); }
  Whole(const Whole&) = delete;
  Whole& operator=(const Whole&) = delete;
  std::array<int, 64> part;
};

TEST(Published, ReadersSeeWholeValuesThatNeverGoBackWhileAWriterSwaps) {
  Published<Whole> published(std::make_shared<const Whole>(0));
  std::atomic<bool> done{false};
  std::atomic<int> faults{0};
  std::atomic<long> reads{0};
  std::vector<std::thread> readers;
  for (int r = 0; r < 3; ++r) {
    readers.emplace_back([&] {
      int last = 0;
      while (!done.load()) {
        const std::shared_ptr<const Whole> value = published.load();
        for (const int part : value->part) faults += part != value->part[0] ? 1 : 0;
        faults += value->part[0] < last ? 1 : 0;
        last = value->part[0];
        ++reads;
      }
    });
  }
  int n = 0;
  while (n < 5000 || reads.load() < 10000) published.store(std::make_shared<const Whole>(++n));
  done = true;
  for (std::thread& reader : readers) reader.join();
  EXPECT_EQ(faults.load(), 0);
  EXPECT_EQ(published.load()->part[0], n);
}

TEST(Published, TheOldValueLivesAsLongAsSomebodyHoldsItAndNoLonger) {
  std::weak_ptr<const Whole> watch;
  Published<Whole> published(std::make_shared<const Whole>(1));
  {
    const std::shared_ptr<const Whole> held = published.load();
    watch = held;
    published.store(std::make_shared<const Whole>(2));
    EXPECT_EQ(held->part[7], 1);
    EXPECT_FALSE(watch.expired());
  }
  EXPECT_TRUE(watch.expired()) << "nothing else keeps a forecast that nobody uses";
}

}  // namespace
}  // namespace slackwater::published_test
