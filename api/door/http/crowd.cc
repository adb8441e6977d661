#include "api/door/http/crowd.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "api/door/http/server_options.h"
#include "api/door/http/session.h"

namespace slackwater::api::http {
namespace {

struct Candidate {
  std::shared_ptr<Session> session;
  Standing standing;
  std::size_t of_client = 0;  ///< how many like it the same client has
};

bool has_kept_us_waiting(const Standing& standing, const Limits& limits, Moment now) {
  const auto waited = now - standing.since;
  switch (standing.wait) {
    case Wait::says_nothing:
      return waited >= limits.patience / 10;
    case Wait::reads_slowly:  // has been given its time already
    case Wait::has_said_all:
      return true;
    case Wait::at_rest:
      break;
  }
  return waited >= limits.patience;
}

}  // namespace

std::vector<std::shared_ptr<Session>> those_to_displace(
    const std::vector<std::shared_ptr<Session>>& sessions, const Limits& limits, Moment now,
    std::size_t most) {
  std::vector<Candidate> candidates;
  std::map<std::pair<Wait, std::string>, std::size_t> counts;
  for (const auto& session : sessions) {
    const auto standing = session->standing(now);
    if (!standing) continue;
    ++counts[{standing->wait, session->client()}];
    if (has_kept_us_waiting(*standing, limits, now)) candidates.push_back({session, *standing});
  }
  for (Candidate& one : candidates)
    one.of_client = counts[{one.standing.wait, one.session->client()}];
  const auto rank = [](const Candidate& one) {
    return std::tuple(one.standing.wait, -static_cast<std::ptrdiff_t>(one.of_client),
                      one.standing.since);
  };
  const std::size_t count = std::min(most, candidates.size());
  std::partial_sort(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(count),
                    candidates.end(),
                    [&](const Candidate& a, const Candidate& b) { return rank(a) < rank(b); });
  std::vector<std::shared_ptr<Session>> displaced;
  for (std::size_t i = 0; i < count; ++i) displaced.push_back(candidates[i].session);
  return displaced;
}

std::vector<std::shared_ptr<Session>> those_to_cut_off(
    const std::vector<std::shared_ptr<Session>>& sessions, const std::string& client,
    std::size_t bytes, const Limits& limits, Moment now) {
  std::vector<std::shared_ptr<Session>> readers;
  std::map<std::string, std::size_t> held{{client, 0}};
  std::size_t all = bytes;
  for (const auto& session : sessions) {
    const std::size_t of_session = session->answer_bytes();
    if (of_session == 0) continue;
    readers.push_back(session);
    held[session->client()] += of_session;
    all += of_session;
  }
  std::sort(readers.begin(), readers.end(),
            [](const auto& a, const auto& b) { return a->answer_bytes() > b->answer_bytes(); });

  std::vector<std::shared_ptr<Session>> found;
  const auto cut_off = [&](std::vector<std::shared_ptr<Session>>::iterator reader) {
    all -= (*reader)->answer_bytes();
    held[(*reader)->client()] -= (*reader)->answer_bytes();
    found.push_back(*reader);
    readers.erase(reader);
  };
  const auto is_slow = [&](const std::shared_ptr<Session>& reader) {
    const auto standing = reader->standing(now);
    return standing && standing->wait == Wait::reads_slowly;
  };
  while (all > limits.answer_bytes) {
    const auto slow = std::find_if(readers.begin(), readers.end(), is_slow);
    if (slow == readers.end()) break;
    cut_off(slow);
  }
  const std::size_t share = limits.answer_bytes / held.size();
  if (held[client] + bytes > share) return found;
  while (all > limits.answer_bytes) {
    const auto most = std::max_element(
        held.begin(), held.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most->second <= share) break;
    cut_off(std::find_if(readers.begin(), readers.end(),
                         [&](const auto& reader) { return reader->client() == most->first; }));
  }
  return found;
}

}  // namespace slackwater::api::http
