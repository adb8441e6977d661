#include "api/pipeline/fetch/fetch_site.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <thread>

#include "api/pipeline/fetch/arrived.h"
#include "api/pipeline/fetch/fetch_note.h"
#include "fields/base/error.h"
#include "fields/base/folder_lock.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// What the requests of one fetch share.
class Fetching {
 public:
  Fetching(const std::vector<Fetcher>& fetchers, const ingest::ProductCatalogue& products,
           const Site& site, UtcTime now, const FetchChoice& choice)
      : fetchers_(fetchers),
        products_(products),
        site_(site),
        now_(now),
        choice_(choice),
        until_(Clock::now() + choice.patience) {}

  [[nodiscard]] FetchOutcome fetch(const WantedFile& wanted);

 private:
  [[nodiscard]] bool is_over() const {
    return (choice_.is_stop_asked != nullptr && *choice_.is_stop_asked) || Clock::now() >= until_;
  }
  /// False: there is no time left for it.
  bool wait(milliseconds how_long) const;
  /// By one fetcher, as often as that helps. @return whether it came
  bool by(const Fetcher& fetcher, const WantedFile& wanted, FetchOutcome& out);
  std::optional<Trouble> request(const Fetcher& fetcher, const WantedFile& wanted,
                                 const std::filesystem::path& target, const std::string& address,
                                 FetchOutcome& out);
  /// All its steps, one after the other, as one file; those that came before a trouble stay.
  std::optional<Trouble> steps(const Fetcher& fetcher, const WantedFile& wanted,
                               const std::filesystem::path& target, FetchOutcome& out);
  void take(const WantedFile& wanted, const std::filesystem::path& target, const Arrived& arrived,
            FetchOutcome& out) const;

  [[nodiscard]] std::filesystem::path part(const std::string& name) const {
    return choice_.folder / ".fetching" / name;
  }

  const std::vector<Fetcher>& fetchers_;
  const ingest::ProductCatalogue& products_;
  const Site& site_;
  UtcTime now_;
  const FetchChoice& choice_;
  Clock::time_point until_;
};

bool Fetching::wait(milliseconds how_long) const {
  const auto until = Clock::now() + how_long;
  if (until >= until_) return false;
  while (Clock::now() < until) {
    if (is_over()) return false;
    std::this_thread::sleep_for(std::min<milliseconds>(
        milliseconds(100),
        std::chrono::duration_cast<milliseconds>(until - Clock::now()) + milliseconds(1)));
  }
  return !is_over();
}

std::optional<Trouble> Fetching::request(const Fetcher& fetcher, const WantedFile& wanted,
                                         const std::filesystem::path& target,
                                         const std::string& address, FetchOutcome& out) {
  const FetchRequest request = request_for(fetcher, wanted, target, address);
  ProgramAsked asked;
  asked.arguments = request.arguments;
  asked.environment = environment_of(fetcher);
  asked.longest = fetcher.longest;
  asked.memory_bytes = static_cast<std::uint64_t>(fetcher.memory_gb * 1e9);
  const ProgramEnded ended = run_program(asked, choice_.is_stop_asked);
  if (ended.end == ProgramEnded::End::exited && ended.status == 0) return std::nullopt;
  const Trouble trouble = trouble_of(fetcher, ended);
  const std::string said = last_word(fetcher, ended.output);
  out.why = words_of(trouble) + (said.empty() ? std::string() : ": " + said);
  return trouble;
}

void append(const std::filesystem::path& part, std::ofstream& whole) {
  std::ifstream from(part, std::ios::binary);
  std::array<char, 1 << 16> bytes{};
  while (from.read(bytes.data(), bytes.size()) || from.gcount() > 0)
    whole.write(bytes.data(), from.gcount());
}

std::optional<Trouble> Fetching::steps(const Fetcher& fetcher, const WantedFile& wanted,
                                       const std::filesystem::path& target, FetchOutcome& out) {
  const std::filesystem::path folder =
      part(wanted.file + "_" + format_utc(wanted.run.value_or(UtcTime{})));
  std::filesystem::create_directories(folder);
  for (std::size_t i = 0; i < wanted.addresses.size(); ++i) {
    const std::filesystem::path step = folder / formatted("{:03}", i);
    if (std::filesystem::exists(step)) continue;
    const std::filesystem::path coming = folder / formatted("{:03}.coming", i);
    if (const auto trouble = request(fetcher, wanted, coming, wanted.addresses[i], out)) {
      out.why += formatted(" (step {} of {})", i + 1, wanted.addresses.size());
      return trouble;
    }
    std::error_code problem;
    std::filesystem::rename(coming, step, problem);
    if (problem) {
      out.why = "its program ended well and left no file";
      return Trouble::damaged;
    }
    if (i + 1 < wanted.addresses.size() && !wait(fetcher.between)) return Trouble::too_slow;
  }
  std::ofstream whole(target, std::ios::binary | std::ios::trunc);
  for (std::size_t i = 0; i < wanted.addresses.size(); ++i)
    append(folder / formatted("{:03}", i), whole);
  whole.close();
  std::error_code problem;
  std::filesystem::remove_all(folder, problem);
  if (whole) return std::nullopt;
  out.why = words_of(Trouble::no_room);
  return Trouble::no_room;
}

void Fetching::take(const WantedFile& wanted, const std::filesystem::path& target,
                    const Arrived& arrived, FetchOutcome& out) const {
  std::filesystem::rename(target, out.file);
  write_note(out.file,
             {asked_text(wanted), now_, std::filesystem::file_size(out.file), arrived.lacks});
  out.state = arrived.lacks.empty() ? FetchState::fetched : FetchState::late;
  out.trouble = arrived.lacks.empty() ? std::nullopt : std::optional(Trouble::updating);
  out.why = arrived.lacks.empty() ? "" : "it " + arrived.lacks + ": the rest is not out yet";
}

bool Fetching::by(const Fetcher& fetcher, const WantedFile& wanted, FetchOutcome& out) {
  const std::filesystem::path target = part(wanted.file);
  milliseconds pause = fetcher.first_wait;
  out.by = fetcher.id;
  for (int attempt = 1; attempt <= fetcher.attempts; ++attempt) {
    if (attempt > 1) {
      if (!wait(pause)) return false;
      pause *= 2;
    }
    if (is_over()) return false;
    ++out.tries;
    if (choice_.on_step)
      choice_.on_step(wanted.kind + " by " + fetcher.id +
                      (attempt > 1 ? formatted(", try {}", attempt) : std::string()));
    std::error_code problem;
    std::filesystem::remove(target, problem);
    out.trouble = fetcher.is_asked_by_step() ? steps(fetcher, wanted, target, out)
                                             : request(fetcher, wanted, target, "", out);
    if (!out.trouble) {
      const Arrived arrived = look_into(target, wanted, products_, site_, part("scratch"));
      if (arrived.fault.empty()) {
        take(wanted, target, arrived, out);
        return true;
      }
      out.trouble = Trouble::damaged;
      out.why = words_of(Trouble::damaged) + (": " + arrived.fault);
    }
    if (!is_passing(*out.trouble)) return false;
  }
  return false;
}

FetchOutcome Fetching::fetch(const WantedFile& wanted) {
  FetchOutcome out;
  out.wanted = wanted;
  if (wanted.file.empty()) {
    out.state = FetchState::none;
    out.why = wanted.why_not;
    return out;
  }
  const Issues issues = issues_of(wanted, products_, now_);
  out.next_out = issues.next;
  out.file = choice_.folder / wanted.file;
  const std::optional<FetchNote> note = note_of(out.file);
  const bool is_newest = note && note->asked == asked_text(wanted) &&
                         (!issues.newest || note->fetched_at >= *issues.newest);
  if (is_newest && note->lacks.empty()) {
    out.state = FetchState::here;
    return out;
  }
  std::vector<std::string> whys;
  bool is_not_out = false;
  for (const Fetcher& fetcher : fetchers_) {
    if (!fetcher.fetches(wanted.kind)) continue;
    if (choice_.is_dry) {
      out.state = FetchState::none;
      out.by = fetcher.id;
      out.why = "would be fetched";
      return out;
    }
    out.trouble = Trouble::stopped;
    out.why = "there was no time left for it";
    if (by(fetcher, wanted, out)) return out;
    whys.push_back(fetcher.id + ": " + out.why);
    is_not_out = is_not_out || *out.trouble == Trouble::updating;
    if (is_over()) break;
  }
  if (whys.empty()) {
    whys.emplace_back("no fetcher serves it: see fetchers/ in the data folder");
    out.trouble = Trouble::refused;
  }
  if (is_not_out) out.trouble = Trouble::updating;
  out.state = is_not_out ? FetchState::late : FetchState::failed;
  out.why = joined(whys, "; ");
  std::error_code problem;
  if (note)
    out.why += "; that of " + format_utc(note->fetched_at) + " is still there";
  else if (!std::filesystem::exists(out.file, problem))
    out.file.clear();
  return out;
}

constexpr std::array state_names{"here", "fetched", "late", "failed", "none"};

}  // namespace

const char* name_of(FetchState state) noexcept {
  return state_names[static_cast<std::size_t>(state)];
}

std::vector<FetchOutcome> fetch_site(const std::vector<WantedFile>& wanted,
                                     const std::vector<Fetcher>& fetchers,
                                     const ingest::ProductCatalogue& products, const Site& site,
                                     UtcTime now, const FetchChoice& choice) {
  std::optional<FolderLock> lock;
  if (!choice.is_dry) {
    std::error_code problem;
    std::filesystem::create_directories(choice.folder / ".fetching", problem);
    if (problem)
      throw Error(ErrorKind::unavailable,
                  "cannot make the folder " + choice.folder.string() + ": " + problem.message());
    lock.emplace(choice.folder);
  }
  Fetching fetching(fetchers, products, site, now, choice);
  std::vector<FetchOutcome> outcomes;
  for (const WantedFile& file : wanted) outcomes.push_back(fetching.fetch(file));
  return outcomes;
}

}  // namespace slackwater::api
