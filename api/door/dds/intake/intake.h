#pragma once
#include <array>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "api/door/dds/intake/begun_samples.h"
#include "api/door/dds/intake/budget.h"

namespace slackwater::dds {

/// Looks at what comes in by UDP before the library does, which believes nearly all that it is
/// told: lets in what peers say, sheds what nobody can mean and what would cost more than it is
/// worth, and names what it shed. What is shed and was meant is said again: announcements are
/// repeated, and of samples that were lost the library reminds their writer.
///
/// It keeps the process alive and small. It keeps nobody out: RTPS says nothing of who sent what,
/// and who sends as a peer does is one.
///
/// Members are for any thread.
class Intake {
 public:
  using Time = Budget::Time;
  using Bytes = std::vector<std::uint8_t>;
  using Payload = std::span<const std::uint8_t>;
  using Tell = std::function<void(const std::string&)>;
  using Source = std::function<std::string()>;

  static constexpr std::size_t most_participants = 256;  ///< heard at a time

  /// @param tell  what operators should know of; may be called from `admit`
  explicit Intake(Tell tell) : tell_(std::move(tell)) {}

  /// @param source  its address, for people
  /// @param changed  room for a datagram that is let in otherwise than it came
  /// @return what the library is to see; empty: nothing
  [[nodiscard]] Payload admit(Payload bytes, const Source& source, Bytes& changed, Time now);

  /// Our own: its echo is nobody's word.
  void be(const Prefix& own);
  /// The library hears this participant, or does no longer.
  void found(const Prefix& participant);
  void lost(const Prefix& participant);
  /// What was shed since it was last told.
  void tell_rest();

 private:
  enum Kind : std::size_t { no_rtps, crowd, rush, strangers, discovery, gaps, pieces, kinds };
  struct Shed {
    std::uint64_t count = 0;
    std::uint64_t told = 0;
    Time told_at{};
    std::string last;  ///< from whom, and why
  };

  [[nodiscard]] std::optional<Kind> refused(Payload bytes, const Datagram& datagram, Time now);
  [[nodiscard]] bool takes_pieces(Payload bytes, Time now);
  void shed(Kind kind, std::string_view fault, const Source& source, Time now);
  [[nodiscard]] static std::string text(Kind kind, const Shed& shed);

  Tell tell_;
  std::mutex mutex_;
  std::optional<Prefix> own_;
  std::set<Prefix> known_;
  BegunSamples begun_;
  Budget newcomers_{512, 32};
  Budget discovery_bytes_{16e6, 128e3};
  Budget skipped_{1 << 18, 1 << 10};
  Budget begun_bytes_{64e6, 4e6};
  std::array<Shed, kinds> shed_;
};

}  // namespace slackwater::dds
