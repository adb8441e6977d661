#include <set>

#include "fields/base/error.h"
#include "fields/base/numbers/random.h"
#include "tests/api/door/dds/readers_for_tests.h"
#include "tests/bench/counted_allocations.h"

// What clients send that is no such message: each reader says so and nothing else happens.

namespace slackwater::dds::broken_messages_test {
namespace {

using tests::Order;
using tests::reader_cases;
using tests::ReaderCase;

/// The message of the refusal; "" where it was taken. Of anything else the test knows no more.
std::string refusal_of(const ReaderCase& reader, const Bytes& bytes) {
  try {
    reader.read(bytes);
    return {};
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::invalid_input) << reader.name;
    return e.message();
  }
}

TEST(BrokenMessages, WholeOnesAreTaken) {
  for (const ReaderCase& reader : reader_cases())
    for (const Order order : {Order::little, Order::big})
      EXPECT_EQ(refusal_of(reader, reader.message(order)), "") << reader.name;
}

TEST(BrokenMessages, CutAtAnyByteTheyAreRefused) {
  for (const ReaderCase& reader : reader_cases()) {
    for (const Order order : {Order::little, Order::big}) {
      const Bytes whole = reader.message(order);
      for (std::size_t size = 0; size < whole.size(); ++size) {
        const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
        EXPECT_NE(refusal_of(reader, cut), "") << reader.name << " cut at " << size;
      }
    }
  }
}

TEST(BrokenMessages, UpToThreeBytesOfPaddingAreTakenAndNoMore) {
  for (const ReaderCase& reader : reader_cases()) {
    Bytes bytes = reader.message();
    for (std::uint8_t i = 1; i <= 3; ++i) {
      bytes.push_back(0);
      bytes[3] = i;  // Cyclone DDS says how many there are
      EXPECT_EQ(refusal_of(reader, bytes), "") << reader.name << " " << i;
    }
    bytes.push_back(0);
    EXPECT_NE(refusal_of(reader, bytes).find("another type"), std::string::npos) << reader.name;
  }
}

TEST(BrokenMessages, OtherEncapsulationsAreRefused) {
  for (const ReaderCase& reader : reader_cases()) {
    // PL_CDR, XCDR2 plain, delimited and with parameters, in both orders; and nonsense.
    for (const auto& [high, low] : {std::pair{0, 2},
                                    {0, 3},
                                    {0, 6},
                                    {0, 7},
                                    {0, 8},
                                    {0, 9},
                                    {0, 10},
                                    {0, 11},
                                    {1, 1},
                                    {255, 255}}) {
      Bytes bytes = reader.message();
      bytes[0] = static_cast<std::uint8_t>(high);
      bytes[1] = static_cast<std::uint8_t>(low);
      EXPECT_NE(refusal_of(reader, bytes).find("not plain CDR"), std::string::npos)
          << reader.name << " " << high << " " << low;
    }
  }
}

TEST(BrokenMessages, OfAnotherTypeAreRefused) {
  // Nothing tells these apart: the last may be padding, or all are numbers of 24 bytes.
  const std::set<std::pair<std::string, std::string>> alike{{"waypoints", "set_waypoints"},
                                                            {"set_bool", "trigger"},
                                                            {"trigger", "set_bool"},
                                                            {"trigger", "step"},
                                                            {"set_bool", "step"}};
  const std::set<std::string> numbers{"query_profile", "cancel_goal", "host_request"};
  for (const ReaderCase& reader : reader_cases()) {
    for (const ReaderCase& other : reader_cases()) {
      if (reader.name == other.name || alike.contains({reader.name, other.name})) continue;
      if (numbers.contains(reader.name) && numbers.contains(other.name)) continue;
      EXPECT_NE(refusal_of(reader, other.message()), "") << other.name << " as " << reader.name;
    }
  }
}

/// rmw_cyclonedds puts its own header into requests: the client's id and a count, eight bytes each
/// (rmw_cyclonedds #184, #577: servers that take them for fields run out of memory).
TEST(BrokenMessages, RequestsWithTheHeaderOfRmwCycloneddsAreRefused) {
  Rng random(5, "tests/dds/cyclone");
  for (const ReaderCase& reader : reader_cases()) {
    if (!reader.is_service) continue;
    const Bytes plain = reader.message();
    for (int i = 0; i < 500; ++i) {
      const std::uint64_t client = i == 0 ? 0 : i == 1 ? 1 : random.bits();
      Bytes bytes(plain.begin(), plain.begin() + 4);
      for (const std::uint64_t part : {client, std::uint64_t(i)}) {
        const auto eight = tests::bytes_of(part, Order::little);
        bytes.insert(bytes.end(), eight.begin(), eight.end());
      }
      bytes.insert(bytes.end(), plain.begin() + 4, plain.end());
      EXPECT_NE(refusal_of(reader, bytes), "") << reader.name << " " << i;
    }
  }
}

/// Counts that promise more than there is: no room is made for them.
TEST(BrokenMessages, PromisesOfManyElementsCostNothing) {
  constexpr std::size_t behind = 60'000;
  for (const ReaderCase& reader : reader_cases()) {
    const Bytes whole = reader.message();
    // Each aligned word in turn takes numbers that fit the bytes there are, or do not.
    for (std::size_t at = 4; at + 4 <= whole.size(); at += 4) {
      for (const std::uint32_t count : {std::uint32_t(behind), 0x7FFFFFFFU, 0xFFFFFFFFU}) {
        Bytes bytes = whole;
        bytes.resize(whole.size() + behind);
        const auto four = tests::bytes_of(count, Order::little);
        std::copy(four.begin(), four.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at));
        const std::size_t before = bench::allocated_bytes();
        (void)refusal_of(reader, bytes);
        EXPECT_LT(bench::allocated_bytes() - before, 6 * bytes.size())
            << reader.name << ": " << count << " at byte " << at;
      }
    }
  }
}

}  // namespace
}  // namespace slackwater::dds::broken_messages_test
