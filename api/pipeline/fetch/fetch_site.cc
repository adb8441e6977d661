#include "api/pipeline/fetch/fetch_site.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <thread>

#include "api/pipeline/fetch/arrived.h"
#include "api/pipeline/fetch/fetch_note.h"
#include "api/pipeline/fetch/gfs_run.h"
#include "fields/base/error.h"
#include "fields/base/folder_lock.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// What one fetcher has said last of a file that it did not bring.
struct Answer {
  std::string by;
  std::string why;
  bool is_passing = false;
};

/// A file that is being fetched.
struct InHand {
  FetchOutcome out;
  bool is_done = false;
  std::vector<Answer> answers;  ///< one a fetcher that was asked
  bool is_not_out = false;      ///< one of them says that it is not out yet

  [[nodiscard]] Answer& answer_of(const std::string& fetcher) {
    const auto found = std::find_if(answers.begin(), answers.end(),
                                    [&](const Answer& answer) { return answer.by == fetcher; });
    return found != answers.end() ? *found : answers.emplace_back(Answer{fetcher, "", false});
  }
  /// Whether a fetcher is to be asked in a round: all in the first, then those that it may help.
  [[nodiscard]] bool asks(const Fetcher& fetcher, int number) const {
    if (is_done || number > fetcher.attempts || !fetcher.fetches(out.wanted.kind)) return false;
    if (fetcher.is_asked_by_step() && out.wanted.addresses.empty()) return false;
    return number == 1 || std::any_of(answers.begin(), answers.end(), [&](const Answer& answer) {
             return answer.by == fetcher.id && answer.is_passing;
           });
  }
};

/// A step of a forecast in GRIB is whole where it begins and ends as messages do.
bool is_whole_grib(const std::filesystem::path& file) {
  std::ifstream from(file, std::ios::binary | std::ios::ate);
  const auto bytes = static_cast<std::streamoff>(from.tellg());
  std::array<char, 4> first{}, last{};
  if (!from || bytes < 20) return false;
  from.seekg(0).read(first.data(), first.size());
  from.seekg(bytes - 4).read(last.data(), last.size());
  return from && std::string_view(first.data(), 4) == "GRIB" &&
         std::string_view(last.data(), 4) == "7777";
}

void append(const std::filesystem::path& part, std::ofstream& whole) {
  std::ifstream from(part, std::ios::binary);
  std::array<char, 1 << 16> bytes{};
  while (from.read(bytes.data(), bytes.size()) || from.gcount() > 0)
    whole.write(bytes.data(), from.gcount());
}

/// The requests of one fetch.
class Fetching {
 public:
  Fetching(const std::vector<Fetcher>& fetchers, const ingest::ProductCatalogue& products,
           const Site& site, UtcTime now, const FetchChoice& choice)
      : fetchers_(fetchers),
        products_(products),
        site_(site),
        now_(now),
        choice_(choice),
        until_(Clock::now() + choice.patience),
        run_folder_(hidden("run-" + std::to_string(::getpid()))) {}

  /// A folder of what comes, for this run alone: what a killed one has left may still be written to
  /// by what it started. Steps of this run of the model are kept.
  void sweep(const std::vector<WantedFile>& wanted) const;
  [[nodiscard]] InHand begun(const WantedFile& wanted) const;
  /// Another try of all that may come, each once, so that none waits for another one's service.
  void round(int number, std::vector<InHand>& files);
  [[nodiscard]] FetchOutcome ended(InHand file) const;

  /// Until the next round. False: there is no time left for it, or nothing that it would help.
  [[nodiscard]] bool wait_for_round(int number, const std::vector<InHand>& files) const;
  void end() const {
    std::error_code problem;
    std::filesystem::remove_all(run_folder_, problem);
  }

 private:
  [[nodiscard]] bool is_stopped() const {
    return choice_.is_stop_asked != nullptr && *choice_.is_stop_asked;
  }
  [[nodiscard]] bool is_over() const { return is_stopped() || Clock::now() >= until_; }
  [[nodiscard]] bool wait(milliseconds how_long) const;
  void try_once(int number, std::size_t files_left, InHand& file);
  /// @return whether it came
  bool by(const Fetcher& fetcher, int number, std::size_t files_left, InHand& file);
  std::optional<Trouble> request(const Fetcher& fetcher, const WantedFile& wanted,
                                 const std::filesystem::path& target, const std::string& address,
                                 std::size_t files_left, std::string& why) const;
  /// All its steps, one after the other, as one file; those that came before a trouble stay.
  std::optional<Trouble> steps(const Fetcher& fetcher, const WantedFile& wanted,
                               const std::filesystem::path& target, std::size_t files_left,
                               std::string& why) const;
  void take(const WantedFile& wanted, const std::filesystem::path& target, const Arrived& arrived,
            FetchOutcome& out) const;

  [[nodiscard]] std::filesystem::path hidden(const std::string& name) const {
    return choice_.folder / ".fetching" / name;
  }
  [[nodiscard]] std::filesystem::path steps_folder(const WantedFile& wanted) const {
    return hidden("steps-" + wanted.file + "-" + format_utc(wanted.run.value_or(UtcTime{})));
  }

  const std::vector<Fetcher>& fetchers_;
  const ingest::ProductCatalogue& products_;
  const Site& site_;
  UtcTime now_;
  const FetchChoice& choice_;
  Clock::time_point until_;
  std::filesystem::path run_folder_;
};

void Fetching::sweep(const std::vector<WantedFile>& wanted) const {
  std::error_code problem;
  for (const auto& entry : std::filesystem::directory_iterator(choice_.folder / ".fetching")) {
    const bool is_kept = std::any_of(wanted.begin(), wanted.end(), [&](const WantedFile& file) {
      return file.run && entry.path() == steps_folder(file);
    });
    if (!is_kept) std::filesystem::remove_all(entry.path(), problem);
  }
  std::filesystem::create_directories(run_folder_);
}

InHand Fetching::begun(const WantedFile& wanted) const {
  InHand file;
  FetchOutcome& out = file.out;
  out.wanted = wanted;
  file.is_done = true;
  if (wanted.file.empty()) {
    out.state = FetchState::none;
    out.why = wanted.why_not;
    return file;
  }
  out.next_out = next_out(wanted, products_, now_);
  out.file = choice_.folder / wanted.file;
  const std::optional<FetchNote> note = note_of(out.file);
  // No file says which run of its product it is of: what is older than that is asked for again.
  constexpr std::chrono::hours fresh{3};
  const bool never_changes = wanted.run || !wanted.from;
  if (note && note->asked == asked_text(wanted) && note->lacks.empty() &&
      (never_changes || (note->fetched_at <= now_ && now_ - note->fetched_at < fresh))) {
    out.state = FetchState::here;
    return file;
  }
  const auto serves = [&](const Fetcher& fetcher) { return fetcher.fetches(wanted.kind); };
  const auto first = std::find_if(fetchers_.begin(), fetchers_.end(), serves);
  if (first == fetchers_.end()) {
    out.trouble = Trouble::refused;
    file.answers = {{"", "no fetcher serves it: see fetchers/ in the data folder", false}};
  } else if (choice_.is_dry) {
    out.state = FetchState::none;
    out.by = first->id;
    out.why = "would be fetched";
    return file;
  }
  file.is_done = false;
  return file;
}

bool Fetching::wait(milliseconds how_long) const {
  const auto until = Clock::now() + how_long;
  if (until >= until_) return false;
  constexpr milliseconds tick{100};
  while (Clock::now() < until && !is_over())
    std::this_thread::sleep_for(std::min(
        tick, std::chrono::duration_cast<milliseconds>(until - Clock::now()) + milliseconds(1)));
  return !is_over();
}

bool Fetching::wait_for_round(int number, const std::vector<InHand>& files) const {
  milliseconds pause{0};
  bool helps = false;
  for (const InHand& file : files)
    for (const Fetcher& fetcher : fetchers_) {
      if (!file.asks(fetcher, number)) continue;
      helps = true;
      pause = std::max(pause, fetcher.first_wait);
    }
  if (!helps) return false;
  for (int i = 2; i < number; ++i) pause *= 2;
  return wait(pause);
}

void Fetching::round(int number, std::vector<InHand>& files) {
  const auto is_left = [&](const InHand& file) {
    return std::any_of(fetchers_.begin(), fetchers_.end(),
                       [&](const Fetcher& fetcher) { return file.asks(fetcher, number); });
  };
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (!is_left(files[i]) || is_over()) continue;
    const auto left =
        std::count_if(files.begin() + static_cast<std::ptrdiff_t>(i), files.end(), is_left);
    try_once(number, static_cast<std::size_t>(left), files[i]);
  }
}

void Fetching::try_once(int number, std::size_t files_left, InHand& file) {
  try {
    for (const Fetcher& fetcher : fetchers_) {
      if (!file.asks(fetcher, number)) continue;
      if (by(fetcher, number, files_left, file)) return;
      if (is_over()) break;
    }
  } catch (const Error& problem) {  // the others go on
    file.answer_of(file.out.by) = {file.out.by, problem.message(), false};
    file.out.trouble = Trouble::unknown;
  } catch (const std::filesystem::filesystem_error& problem) {
    const bool is_full = problem.code() == std::errc::no_space_on_device;
    file.out.trouble = is_full ? Trouble::no_room : Trouble::unknown;
    file.answer_of(file.out.by) = {file.out.by,
                                   is_full ? words_of(Trouble::no_room) : problem.what(), false};
  }
  std::error_code problem;
  std::filesystem::remove(run_folder_ / file.out.wanted.file, problem);
}

std::optional<Trouble> Fetching::request(const Fetcher& fetcher, const WantedFile& wanted,
                                         const std::filesystem::path& target,
                                         const std::string& address, std::size_t files_left,
                                         std::string& why) const {
  const FetchRequest request = request_for(fetcher, wanted, target, address);
  ProgramAsked asked;
  asked.arguments = request.arguments;
  asked.environment = environment_of(fetcher);
  // A fair part of the time that is left, and five minutes at least.
  constexpr std::chrono::seconds least{300};
  const auto left = std::chrono::ceil<std::chrono::seconds>(until_ - Clock::now());
  const auto part = std::max(left / static_cast<long>(std::max<std::size_t>(files_left, 1)), least);
  asked.longest = std::max(std::min({fetcher.longest, part, left}), std::chrono::seconds(1));
  asked.memory_bytes = static_cast<std::uint64_t>(fetcher.memory_gb * 1e9);
  const ProgramEnded ended = run_program(asked, choice_.is_stop_asked);
  if (ended.end == ProgramEnded::End::exited && ended.status == 0) return std::nullopt;
  Trouble trouble = trouble_of(fetcher, ended);
  // What was due long ago is not late any more.
  constexpr std::chrono::hours grace{3};
  if (trouble == Trouble::updating && wanted.run &&
      now_ > *wanted.run + gfs_published_after + grace)
    trouble = Trouble::refused;
  const std::string said = last_word(fetcher, ended.output);
  why = words_of(trouble) + (said.empty() ? std::string() : ": " + said);
  return trouble;
}

std::optional<Trouble> Fetching::steps(const Fetcher& fetcher, const WantedFile& wanted,
                                       const std::filesystem::path& target, std::size_t files_left,
                                       std::string& why) const {
  const std::filesystem::path folder = steps_folder(wanted);
  std::filesystem::create_directories(folder);
  const std::filesystem::path coming = run_folder_ / "step";
  for (std::size_t i = 0; i < wanted.addresses.size(); ++i) {
    const std::filesystem::path step = folder / formatted("{:03}", i);
    const std::string which = formatted(" (step {} of {})", i + 1, wanted.addresses.size());
    if (std::filesystem::exists(step)) continue;
    std::error_code problem;
    std::filesystem::remove(coming, problem);
    if (const auto trouble =
            request(fetcher, wanted, coming, wanted.addresses[i], files_left, why)) {
      why += which;
      return trouble;
    }
    if (!is_whole_grib(coming)) {
      why = words_of(Trouble::damaged) + std::string(": found no whole GRIB message") + which;
      return Trouble::damaged;
    }
    std::filesystem::rename(coming, step);
    if (i + 1 == wanted.addresses.size() || wait(fetcher.between)) continue;
    why = std::string(words_of(Trouble::stopped)) + which;
    return Trouble::stopped;
  }
  std::ofstream whole(target, std::ios::binary | std::ios::trunc);
  for (std::size_t i = 0; i < wanted.addresses.size(); ++i)
    append(folder / formatted("{:03}", i), whole);
  whole.close();
  if (whole) return std::nullopt;
  why = words_of(Trouble::no_room);
  return Trouble::no_room;
}

void Fetching::take(const WantedFile& wanted, const std::filesystem::path& target,
                    const Arrived& arrived, FetchOutcome& out) const {
  const std::string from = wanted.from ? format_utc(*wanted.from) : "";
  // A longer history that nobody has taken in yet is put aside, not overwritten.
  if (const auto before = note_of(out.file);
      before && !before->from.empty() && before->from.substr(0, 10) < from.substr(0, 10) &&
      parse_utc(before->from) + std::chrono::days(2) < *wanted.from) {
    const std::string day = before->from.substr(0, 10);
    std::filesystem::rename(
        out.file, out.file.parent_path() /
                      (out.file.stem().string() + "_" + day + out.file.extension().string()));
  }
  std::filesystem::rename(target, out.file);
  write_note(out.file,
             {asked_text(wanted), from, now_, std::filesystem::file_size(out.file), arrived.lacks});
  out.state = arrived.lacks.empty() ? FetchState::fetched : FetchState::late;
  out.trouble = arrived.lacks.empty() ? std::nullopt : std::optional(Trouble::updating);
  if (!arrived.lacks.empty())
    out.why = "it " + arrived.lacks + ": the rest is not out yet";
  else if (!arrived.begins.empty())
    out.why = "it " + arrived.begins;
  if (!wanted.run) return;
  std::error_code problem;
  std::filesystem::remove_all(steps_folder(wanted), problem);
}

bool Fetching::by(const Fetcher& fetcher, int number, std::size_t files_left, InHand& file) {
  const WantedFile& wanted = file.out.wanted;
  const std::filesystem::path target = run_folder_ / wanted.file;
  file.out.by = fetcher.id;
  file.out.tries = number;
  if (choice_.on_step)
    choice_.on_step(wanted.kind + " by " + fetcher.id +
                    (number > 1 ? formatted(", try {}", number) : std::string()));
  std::error_code problem;
  std::filesystem::remove(target, problem);
  std::string why;
  std::optional<Trouble> trouble = fetcher.is_asked_by_step()
                                       ? steps(fetcher, wanted, target, files_left, why)
                                       : request(fetcher, wanted, target, "", files_left, why);
  if (!trouble) {
    const Arrived arrived = look_into(target, wanted, products_, site_, run_folder_ / "scratch");
    if (arrived.fault.empty()) {
      take(wanted, target, arrived, file.out);
      file.is_done = true;
      return true;
    }
    trouble = Trouble::damaged;
    why = words_of(Trouble::damaged) + (": " + arrived.fault);
  }
  file.out.trouble = trouble;
  file.answer_of(fetcher.id) = {fetcher.id, why, is_passing(*trouble)};
  file.is_not_out = file.is_not_out || *trouble == Trouble::updating;
  return false;
}

FetchOutcome Fetching::ended(InHand file) const {
  FetchOutcome& out = file.out;
  if (file.is_done) return out;
  if (file.answers.empty()) {
    out.trouble = Trouble::stopped;
    file.answers.push_back(
        {"", is_stopped() ? words_of(Trouble::stopped) : "there was no time left for it", false});
  }
  if (file.is_not_out) out.trouble = Trouble::updating;
  out.state = file.is_not_out ? FetchState::late : FetchState::failed;
  std::vector<std::string> whys;
  for (const Answer& answer : file.answers)
    whys.push_back((answer.by.empty() ? "" : answer.by + ": ") + answer.why);
  out.why = joined(whys, "; ");
  std::error_code problem;
  if (const std::optional<FetchNote> note = note_of(out.file))
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
  Fetching fetching(fetchers, products, site, now, choice);
  if (!choice.is_dry) {
    std::error_code problem;
    std::filesystem::create_directories(choice.folder / ".fetching", problem);
    if (problem)
      throw Error(ErrorKind::unavailable,
                  "cannot make the folder " + choice.folder.string() + ": " + problem.message());
    lock.emplace(choice.folder);
    fetching.sweep(wanted);
  }
  std::vector<InHand> files;
  files.reserve(wanted.size());
  for (const WantedFile& file : wanted) files.push_back(fetching.begun(file));
  for (int number = 1; number == 1 || fetching.wait_for_round(number, files); ++number)
    fetching.round(number, files);
  if (!choice.is_dry) fetching.end();
  std::vector<FetchOutcome> outcomes;
  outcomes.reserve(files.size());
  for (InHand& file : files) outcomes.push_back(fetching.ended(std::move(file)));
  return outcomes;
}

}  // namespace slackwater::api
