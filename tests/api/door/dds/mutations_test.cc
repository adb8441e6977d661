
#include "fields/base/error.h"
#include "fields/base/numbers/random.h"
#include "tests/api/door/dds/readers_for_tests.h"
#include "tests/bench/counted_allocations.h"
#include "tests/support/asked_number.h"

// Messages with something wrong in them, a hundred thousand; SLACKWATER_MUTATIONS of them where
// that is set.

namespace slackwater::dds::mutations_test {
namespace {

using tests::Order;
using tests::ReaderCase;

std::size_t index(Rng& random, std::size_t size) { return random.bits() % size; }

void put_word(Rng& random, Bytes& bytes) {
  if (bytes.size() < 8) return;
  const std::size_t words = (bytes.size() - 4) / 4, at = 4 + 4 * index(random, words);
  const auto left = static_cast<std::uint32_t>(bytes.size() - at - 4);
  const std::uint32_t numbers[] = {0,         1,          left,       left + 1,    left / 4,
                                   left / 72, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFFU, 0x7FF00000};
  const auto word = tests::bytes_of(numbers[index(random, std::size(numbers))],
                                    random.uniform() < 0.5 ? Order::little : Order::big);
  std::copy(word.begin(), word.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at));
}

void change(Rng& random, const std::vector<Bytes>& others, Bytes& bytes) {
  switch (index(random, 6)) {
    case 0:  // a bit
      if (!bytes.empty())
        bytes[index(random, bytes.size())] ^= static_cast<std::uint8_t>(1U << index(random, 8));
      break;
    case 1:  // a byte
      if (!bytes.empty())
        bytes[index(random, bytes.size())] = static_cast<std::uint8_t>(random.bits());
      break;
    case 2:
    case 3:
      put_word(random, bytes);
      break;
    case 4:  // cut or longer
      bytes.resize(index(random, 2 * bytes.size() + 8), static_cast<std::uint8_t>(random.bits()));
      break;
    default: {  // the end of another
      const Bytes& other = others[index(random, others.size())];
      bytes.resize(index(random, bytes.size() + 1));
      bytes.insert(bytes.end(),
                   other.begin() + static_cast<std::ptrdiff_t>(index(random, other.size())),
                   other.end());
    }
  }
}

TEST(MutatedMessages, GiveAValueOrInvalidInputAndTakeNoMemoryToSpeakOf) {
  const int wanted = slackwater::tests::asked_number("SLACKWATER_MUTATIONS", 100'000);
  const std::vector<ReaderCase> readers = tests::reader_cases();
  std::vector<Bytes> whole;
  for (const ReaderCase& reader : readers)
    for (const Order order : {Order::little, Order::big}) whole.push_back(reader.message(order));

  constexpr std::uint64_t seed = 6;
  Rng random(seed, "tests/dds/mutations");
  long taken = 0, refused = 0;
  for (int i = 0; i < wanted; ++i) {
    const std::size_t which = index(random, readers.size());
    Bytes bytes = whole[2 * which + index(random, 2)];
    for (std::size_t n = 1 + index(random, 3); n > 0; --n) change(random, whole, bytes);
    const Bytes tight(bytes.begin(), bytes.end());  // what lies behind it is not ours to read
    const std::size_t before = bench::allocated_bytes();
    try {
      readers[which].read(tight);
      ++taken;
    } catch (const Error& e) {
      ASSERT_EQ(e.kind(), ErrorKind::invalid_input);
      ++refused;
    } catch (const std::exception& e) {
      FAIL() << readers[which].name << ", mutation " << i << " of seed " << seed << ": "
             << e.what();
    }
    // Of an Error the text, and the library's, are a few hundred bytes.
    ASSERT_LT(bench::allocated_bytes() - before, 6 * tight.size() + 4096)
        << readers[which].name << ", mutation " << i << " of seed " << seed;
  }
  EXPECT_GT(taken, wanted / 20) << "some are messages still";
  EXPECT_GT(refused, wanted / 3);
  RecordProperty("taken", std::to_string(taken));
}

}  // namespace
}  // namespace slackwater::dds::mutations_test
