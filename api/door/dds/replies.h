#pragma once
#include <fastdds/rtps/common/SampleIdentity.h>
#include <deque>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <mutex>
#include <vector>

#include "api/door/dds/message/bytes.h"

// Only sources of this folder include this: it shows the library.

namespace slackwater::dds {

/// Answers of a service on their way. A client asks as soon as it sees the service, which may be
/// before the service sees the reader that waits for the answer: what is written then, that reader
/// never gets. So an answer waits until its reader is found; where clients do not name it, until
/// any of their participant is.
///
/// Members are for any thread.
class Replies {
 public:
  using Guid = eprosima::fastrtps::rtps::GUID_t;
  using Identity = eprosima::fastrtps::rtps::SampleIdentity;
  using Writer = eprosima::fastdds::dds::DataWriter;

  void send(Writer& writer, const Identity& to, Bytes reply);
  /// Sends what waited for it.
  void reader_found(Writer& writer, const Guid& reader);
  void reader_lost(const Guid& reader);

 private:
  struct Waiting {
    Identity to;
    Bytes reply;
  };
  std::mutex mutex_;
  std::vector<Guid> readers_;
  std::deque<Waiting> waiting_;  ///< the last of them: a client may never come
};

}  // namespace slackwater::dds
