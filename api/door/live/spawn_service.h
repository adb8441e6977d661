#pragma once
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "api/door/dds/participant.h"
#include "twin/helm/command_arbiter.h"

namespace slackwater::live {

/// `/slackwater/spawn`: a vehicle of the catalogue joins the run, and is answered for once it has
/// its topics and services. Its name is that of all of these: a token of ROS which nobody else has,
/// in whatever case.
///
/// `open`, `speak` and `end_run` are for the thread of the run, requests come on any thread.
class SpawnService {
 public:
  /// @param site  a token of ROS, which no vehicle can have for a name
  SpawnService(dds::Participant& participant, twin::CommandArbiter& arbiter,
               const twin::NewcomerYard& newcomer_yard, const std::string& site);

  /// A vehicle of the run has its topics and services. @param name  by which these go
  void open(const std::string& name);
  /// Answers for those that have come.
  void speak();
  /// Answers for those that will not come any more.
  void end_run();

 private:
  struct Waiting {
    twin::Newcomer newcomer;
    dds::Answer answer;
    bool is_there = false;
  };
  void take(dds::Payload request, const std::string& client, const dds::Answer& answer);
  /// Nobody else gets the name from now on, unless it is refused.
  [[nodiscard]] std::optional<twin::Refusal> reserve(const twin::Newcomer& newcomer,
                                                     const dds::Answer& answer);
  void forget(const std::string& name);

  twin::CommandArbiter& arbiter_;
  const twin::NewcomerYard& newcomer_yard_;
  std::mutex mutex_;
  std::set<std::string> taken_;  ///< names in lower case
  std::vector<Waiting> waiting_;
};

/// Names on DDS that belong to the run itself.
[[nodiscard]] const std::set<std::string>& reserved_names();

}  // namespace slackwater::live
