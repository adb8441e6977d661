#pragma once
#include <functional>
#include <memory>
#include <string>

#include "api/door/dds/message/bytes.h"
#include "data/bag/channel.h"

namespace slackwater::dds {

/// How to be on the wire.
struct DomainSettings {
  int domain = 0;  ///< 0 to 232
  std::string node = "slackwater";
  bool is_loopback_only = false;  ///< nobody on another machine hears it
  /// Address of the network card that it is at, and no other; empty: at all of them.
  std::string interface;
  bool is_udp_only = false;  ///< no shared memory, of which killed processes leave files
  /// What operators should know of: peers whose type or quality of a topic is another one than
  /// ours, messages that are none. From a thread of the participant, one at a time.
  std::function<void(const std::string&)> on_trouble;
};

/// A service: "/slackwater/pause", "std_srvs/srv/Trigger".
struct Service {
  std::string name;
  std::string type;
};

/// Answers one request, once, at any time and from any thread; nothing where the participant is
/// gone.
using Answer = std::function<void(Bytes)>;

/// A ROS 2 node on DDS: topics and services by ROS's conventions (names.h), messages as bytes. It
/// is the one door to Fast DDS.
///
/// Clients are named by their participant: "dds 01.0f.ab.cd...". What it calls is called from
/// threads of the library, several at once; what is thrown there is caught and told to
/// `on_trouble`. Members are for any thread, but not from inside what it calls but for `send` and
/// an `Answer`.
class Participant {
 public:
  using OnMessage = std::function<void(Payload message, const std::string& client)>;
  /// @param held_back_s  longer on its way than its writer's messages were of late; see HeldBack
  using OnTimedMessage =
      std::function<void(Payload message, const std::string& client, double held_back_s)>;
  using OnRequest =
      std::function<void(Payload request, const std::string& client, const Answer& answer)>;
  using OnLost = std::function<void(const std::string& client)>;

  /// Takes away what killed participants left in shared memory, then joins.
  /// @throws Error(invalid_input) for a domain or a network card that there is not,
  ///         Error(unavailable) where the domain cannot be joined
  explicit Participant(DomainSettings settings);
  ~Participant();
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;

  using WriterId = std::size_t;
  [[nodiscard]] WriterId publish_on(const bag::Channel& channel);
  /// Whether anybody would hear it, now or, of what stays for those who come late, ever.
  [[nodiscard]] bool is_heard(WriterId writer) const;
  /// Whether that client has a reader of it that gets what is sent from now on.
  [[nodiscard]] bool is_heard_by(WriterId writer, const std::string& client) const;
  void send(WriterId writer, Payload message);

  /// @param on_left  a client closed its writer of it, or is gone; may be none
  void subscribe(const bag::Channel& channel, OnMessage on_message, OnLost on_left = {});
  void subscribe_timed(const bag::Channel& channel, OnTimedMessage on_message);
  void serve(const Service& service, OnRequest on_request);
  /// A client left, or has not been heard of for its lease.
  void on_lost(OnLost on_lost);
  /// What operators should know of: to `on_trouble`, and as a warning on `/rosout`, for those at
  /// the other side. From inside of anything.
  void tell(const std::string& text) noexcept;
  /// Tells `ros_discovery_info` of all topics and services so far. Call after adding some.
  void announce();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace slackwater::dds
