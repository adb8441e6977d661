#include "ingest/apart/read_apart.h"

#include <cstdlib>
#include <new>
#include <sstream>
#include <string_view>
#include <utility>

#include "fields/base/error.h"
#include "fields/base/given_file.h"
#include "fields/base/log.h"
#include "ingest/apart/packed.h"
#include "ingest/grib/grib_file.h"
#include "ingest/netcdf/magic.h"

namespace slackwater::ingest {
namespace {

/// What a reader tells ends with what it is: the bytes that it read, or why it could not.
constexpr char is_read = 'r', is_problem = 'p';
using Problem = std::pair<ErrorKind, std::string>;

std::string told(const Problem& problem) { return packed(problem) + is_problem; }

std::string told_by(const std::filesystem::path& file, const Allowance& allowance,
                    const std::function<std::string(const TellShare&)>& read,
                    const TellShare& tell) {
  try {
    std::string bytes = read(tell);
    bytes += is_read;
    return bytes;
  } catch (const Error& error) {
    return told({error.kind(), error.message()});
  } catch (const std::bad_alloc&) {
    return told({ErrorKind::invalid_input,
                 "reading " + file.string() + " wants more than " +
                     std::to_string(allowance.memory_bytes >> 30U) +
                     " GB of memory: the file is damaged (fetch it again), or too large (cut it)"});
  } catch (const std::exception& fault) {
    return told({ErrorKind::internal, "reading " + file.string() + ": " + fault.what()});
  }
}

std::string library_of(const std::filesystem::path& file) {
  std::error_code problem;
  if (!std::filesystem::is_regular_file(file, problem)) return "its reader";
  if (is_grib(file)) return "the GRIB library";
  return netcdf::begins_as_netcdf(file) ? "the NetCDF library" : "its reader";
}

/// Once: a coordinator who reads strangers' files without a fence is to know it.
void warn_where_nothing_confines() {
  static const bool is_warned = [] {
    const ConfinementOfSystem system = confinement_of_system();
    if (system.calls && system.files) return false;
    log_event(LogLevel::warning, "files of others are read with more rights than they need",
              {{"problem", system.calls ? "this kernel has no Landlock (Linux 5.13), which bounds "
                                          "what files a reader opens"
                                        : "this kernel, or its container, filters no system calls "
                                          "(seccomp)"},
               {"advice", "read files of strangers on a newer system"}});
    return true;
  }();
  static_cast<void>(is_warned);
}

/// Of a reader that did not answer.
Error error_of(const Apart& apart, const std::filesystem::path& file, const Allowance& allowance) {
  const std::string reading = "reading " + file.string();
  const std::string how =
      apart.signal == 0 ? "it ended without an answer" : "signal " + std::to_string(apart.signal);
  const auto gigabytes = [](std::uint64_t bytes) { return std::to_string(bytes >> 30U) + " GB"; };
  switch (apart.end) {
    case Apart::End::out_of_time:
      return {ErrorKind::invalid_input,
              reading + " took " + library_of(file) + " more than " +
                  std::to_string(allowance.processor.count()) +
                  " s of processor time, or ten times that by the clock: the file is damaged "
                  "(fetch it again), or its disk does not answer"};
    case Apart::End::out_of_memory:
      return {ErrorKind::invalid_input,
              reading + " used more than " + gigabytes(allowance.memory_bytes) +
                  " of memory: the file is damaged (fetch it again), or too large (cut it)"};
    case Apart::End::wrote_too_much:
      return {ErrorKind::invalid_input,
              reading + " unpacks to more than " + gigabytes(allowance.file_bytes) +
                  ": the file is damaged (fetch it again), or too large (cut it)"};
    case Apart::End::killed:
      return {ErrorKind::unavailable,
              reading + " was ended from outside (" + how +
                  "); if the system was short of memory cut the file, else run it again"};
    default:
      return {ErrorKind::invalid_input, reading + " crashed " + library_of(file) + " (" + how +
                                            "): the file is damaged; fetch it again"};
  }
}

}  // namespace

Allowance allowance_for(const std::filesystem::path& file) {
  Allowance allowance;
  std::error_code problem;
  const std::uintmax_t bytes = std::filesystem::file_size(file, problem);
  if (!problem) allowance.processor += std::chrono::seconds(bytes >> 20U);
  allowance.reach.readable = {file, "/usr/share", "/usr/local/share", "/usr/lib/locale",
                              "/etc/localtime"};
  for (const char* const name :
       {"ECCODES_DEFINITION_PATH", "ECCODES_SAMPLES_PATH", "UDUNITS2_XML_PATH"}) {
    const char* const list = std::getenv(name);
    std::stringstream folders(list == nullptr ? "" : list);
    for (std::string folder; std::getline(folders, folder, ':');)
      allowance.reach.readable.emplace_back(folder);
  }
  return allowance;
}

std::string context_of_told(const std::filesystem::path& file) {
  return file.string() + " is damaged, or made to do harm; fetch it again";
}

std::string read_apart(const std::filesystem::path& file, const Allowance& allowance,
                       const std::function<std::string(const TellShare&)>& read,
                       const std::function<void(double)>& on_share,
                       const std::function<void()>& meanwhile) {
  refuse_device(file);
  warn_where_nothing_confines();
  Apart apart = run_apart(
      allowance, [&](const TellShare& tell) { return told_by(file, allowance, read, tell); },
      on_share, meanwhile);
  if (apart.end != Apart::End::answered) throw error_of(apart, file, allowance);
  std::string bytes = std::move(apart.answer);
  const char kind = bytes.empty() ? '\0' : bytes.back();
  if (kind == is_read) {
    bytes.pop_back();
    return bytes;
  }
  const auto [error, message] = with_context(context_of_told(file), [&] {
    if (kind != is_problem) refuse("its reader told neither what it read nor why it could not");
    return unpacked<Problem>(std::string_view(bytes).substr(0, bytes.size() - 1));
  });
  throw Error(error, message);
}

}  // namespace slackwater::ingest
