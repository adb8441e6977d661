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
    case Wait::reads_slowly:
      return true;  // has been given its time already
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

std::vector<std::shared_ptr<Session>> slow_readers(
    const std::vector<std::shared_ptr<Session>>& sessions, std::size_t bytes) {
  std::vector<Candidate> readers;
  const Moment now = std::chrono::steady_clock::now();
  for (const auto& session : sessions) {
    const auto standing = session->standing(now);
    if (standing && standing->wait == Wait::reads_slowly) readers.push_back({session, *standing});
  }
  std::sort(readers.begin(), readers.end(), [](const Candidate& a, const Candidate& b) {
    return a.standing.answer_bytes > b.standing.answer_bytes;
  });
  std::vector<std::shared_ptr<Session>> found;
  std::size_t held = 0;
  for (const Candidate& one : readers) {
    if (held >= bytes) break;
    held += one.standing.answer_bytes;
    found.push_back(one.session);
  }
  return found;
}

}  // namespace slackwater::api::http
