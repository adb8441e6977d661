#pragma once
// What peers of `slackwater live` have in common: what they call and hear, and how they tell what
// they saw.
#include <array>
#include <cstdio>
#include <initializer_list>

#include "nav_msgsPubSubTypes.h"
#include "tests/strangers/live/services.h"

namespace peer {

inline int failures = 0;
inline void expect(bool is_true, const std::string& what) {
  std::printf("%s %s\n", is_true ? "ok  " : "FAIL", what.c_str());
  std::fflush(stdout);
  if (!is_true) ++failures;
}

template <typename Message, typename Support>
std::optional<Message> next(fdds::DataReader* reader, double at_most_s = 5) {
  const auto until = Clock::now() + std::chrono::duration<double>(at_most_s);
  Message message;
  fdds::SampleInfo info;
  while (Clock::now() < until) {
    if (reader->take_next_sample(&message, &info) == ReturnCode_t::RETCODE_OK && info.valid_data)
      return message;
    reader->wait_for_unread_message({0, 20'000'000});
  }
  return std::nullopt;
}

/// The newest there is; waits for one where there is none.
template <typename Message>
std::optional<Message> newest(fdds::DataReader* reader) {
  auto message = next<Message, void>(reader);
  Message later;
  fdds::SampleInfo info;
  while (reader->take_next_sample(&later, &info) == ReturnCode_t::RETCODE_OK)
    if (info.valid_data) message = later;
  return message;
}

inline nav_msgs::msg::Path path_of(std::initializer_list<std::array<double, 3>> places) {
  nav_msgs::msg::Path path;
  path.header().frame_id("map");
  for (const auto& [x, y, z] : places) {
    geometry_msgs::msg::PoseStamped pose;
    pose.pose().position().x(x);
    pose.pose().position().y(y);
    pose.pose().position().z(z);
    path.poses().push_back(pose);
  }
  return path;
}

}  // namespace peer
