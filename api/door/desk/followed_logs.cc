#include "api/door/desk/followed_logs.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <new>

#include "fields/base/attempt.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "ingest/ais/read_ais.h"

namespace slackwater::api::desk {
namespace {

using std::chrono::steady_clock;

/// Read again before what is new: the rest of a message that was not whole, and the stamp before a
/// sentence. More than `MessageAssembler::reach` sentences of fragments never lie between.
constexpr std::uint64_t overlap_bytes = 16'384;
constexpr std::size_t beginning_bytes = 256;
constexpr std::uint64_t some_lines_bytes = 4096;  // that a receiver may well spend on words
/// A log that grows all the time costs this share of a core at most.
constexpr int rest_per_reading = 5;

class Opened {
 public:
  /// Never waits: neither for who writes to a pipe, nor for a device.
  explicit Opened(const std::filesystem::path& path)
      : number_(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY)) {}
  ~Opened() {
    if (number_ >= 0) ::close(number_);
  }
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;
  [[nodiscard]] int number() const noexcept { return number_; }
  /// The very file that was opened, whatever its path names by now.
  [[nodiscard]] std::filesystem::path path() const {
    return "/proc/self/fd/" + std::to_string(number_);
  }
  [[nodiscard]] std::string beginning(std::size_t bytes) const {
    std::string text(bytes, '\0');
    const ssize_t got = ::pread(number_, text.data(), bytes, 0);
    text.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    return text;
  }

 private:
  int number_;
};

/// Why a file cannot be a log; empty: it may be one.
std::string flaw_of_kind(const std::string& name, int problem, mode_t mode) {
  if (problem == ENOENT || problem == ENOTDIR)
    return "The log " + name + " is not there; it is looked for every second.";
  if (problem != 0) return "The log " + name + " cannot be opened: " + std::strerror(problem) + ".";
  if (S_ISREG(mode)) return {};
  return name + " is " +
         (S_ISDIR(mode)    ? "a folder"
          : S_ISFIFO(mode) ? "a pipe"
          : S_ISSOCK(mode) ? "a socket"
                           : "a device") +
         ", expected the file of a log that a receiver writes.";
}

std::string without(std::string text, const std::string& part, const std::string& instead) {
  for (std::size_t at = text.find(part); at != std::string::npos;
       at = text.find(part, at + instead.size()))
    text.replace(at, part.size(), instead);
  return text;
}

/// What of a reading leaves the picture poor.
std::string flaw_of(const std::string& name, const ingest::AisReading& reading) {
  const auto& lines = reading.lines;
  if (lines.malformed > reading.messages)
    return "Of what was written last to " + name + ", " + counted(lines.malformed, "line") +
           (lines.malformed == 1 ? " is" : " are") + " no AIS (" + lines.first_malformed +
           "): look at the receiver.";
  std::size_t reports = 0;
  for (const std::size_t count : reading.reports_of_type) reports += count;
  if (reports > 0 && 2 * reading.untimed > reports)
    return "Reports of " + name +
           " have no time, so that nobody knows how old they are; expected a time in front of each "
           "line, $PGHP lines or tag blocks.";
  return {};
}

}  // namespace

FollowedLogs::FollowedLogs(std::vector<std::filesystem::path> files, LogFollowing following)
    : following_(std::move(following)) {
  for (std::filesystem::path& file : files) {
    Log log;
    log.name = file.filename().string();
    log.trouble = "The log " + log.name + " is being read for the first time.";
    log.path = std::move(file);
    logs_.push_back(std::move(log));
  }
  thread_ = std::thread([this] { follow(); });
}

FollowedLogs::~FollowedLogs() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

TrafficHeard FollowedLogs::heard(UtcTime at) const {
  const std::lock_guard lock(mutex_);
  TrafficHeard heard;
  heard.vessels = vessels_.known_at(at);
  heard.last = vessels_.last_received(at);
  heard.first = vessels_.first();
  for (const Log& log : logs_) heard.sources.push_back({log.name, log.trouble});
  return heard;
}

void FollowedLogs::follow() {
  std::unique_lock lock(mutex_);
  while (!ends_) {
    lock.unlock();
    for (Log& log : logs_) {
      try {
        const auto failure = attempt([&] { look_at(log); });
        if (failure)
          set_trouble(log, "The log " + log.name + " cannot be read: " + failure->why + ".");
      } catch (const std::bad_alloc&) {
        set_trouble(log, "Memory has run out for what the log " + log.name + " holds.");
      }
    }
    lock.lock();
    wake_.wait_for(lock, following_.every, [this] { return ends_; });
  }
}

void FollowedLogs::set_trouble(Log& log, std::string trouble) {
  const std::lock_guard lock(mutex_);
  log.trouble = std::move(trouble);
}

void FollowedLogs::look_at(Log& log) {
  const auto begun = steady_clock::now();
  if (begun < log.not_before) return;
  struct stat now {};
  // What is no file is not even opened: some devices do something then.
  int problem = ::stat(log.path.c_str(), &now) == 0 ? 0 : errno;
  std::string flaw = flaw_of_kind(log.name, problem, now.st_mode);
  if (flaw.empty()) {
    const Opened opened(log.path);
    problem = opened.number() >= 0 && ::fstat(opened.number(), &now) == 0 ? 0 : errno;
    flaw = flaw_of_kind(log.name, problem, now.st_mode);
    if (flaw.empty()) {
      const Mark mark{now.st_dev, now.st_ino, static_cast<std::uint64_t>(now.st_size),
                      now.st_mtim.tv_sec * 1'000'000'000 + now.st_mtim.tv_nsec};
      if (log.mark == mark) return;
      const std::string beginning = opened.beginning(beginning_bytes);
      const bool goes_on = log.mark && log.mark->device == mark.device &&
                           log.mark->file == mark.file && mark.size >= log.read_to &&
                           beginning.starts_with(log.beginning);
      if (!goes_on) log.read_to = 0;
      log.beginning = beginning;
      flaw = read(log, opened.path(), mark);
      log.mark = mark;
      log.read_to = mark.size;
      log.not_before = steady_clock::now() + rest_per_reading * (steady_clock::now() - begun);
      set_trouble(log, flaw);
      return;
    }
  }
  log.mark.reset();
  set_trouble(log, flaw);
}

std::string FollowedLogs::read(Log& log, const std::filesystem::path& opened, const Mark& mark) {
  if (mark.size == 0) return "The log " + log.name + " is empty.";
  const bool is_whole = log.read_to == 0;
  ingest::AisPart part{log.read_to > overlap_bytes ? log.read_to - overlap_bytes : 0, mark.size};
  const bool is_too_large = part.to - part.from > following_.most_bytes;
  if (is_too_large) part.from = part.to - following_.most_bytes;
  ingest::AisReading reading;
  const auto failure = attempt([&] {
    reading = ingest::read_ais_part(
        opened, part,
        [this](const ingest::AisReport& report) {
          const std::lock_guard lock(mutex_);
          if (ends_) throw Error(ErrorKind::unavailable, "the server ends");
          vessels_.add(report);
        },
        following_.decoder);
  });
  if (failure)
    return "The log " + log.name + " cannot be read: " +
           without(without(failure->why, "reading AIS of " + opened.string() + ": ", ""),
                   opened.string(), log.name) +
           ".";
  std::string flaw = flaw_of(log.name, reading);
  if (!flaw.empty()) return flaw;
  if (reading.messages == 0 && is_whole) return "The log " + log.name + " holds no AIS.";
  if (reading.messages == 0 && part.to - part.from > some_lines_bytes)
    return "What was written last to " + log.name + " is no AIS: look at the receiver.";
  if (is_too_large)
    return formatted("Of the log {} only the last {} MB are read: rotate it daily.", log.name,
                     following_.most_bytes >> 20U);
  return {};
}

}  // namespace slackwater::api::desk
