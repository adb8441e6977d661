#include "ingest/apart/read_apart.h"

#include <cstdlib>
#include <new>
#include <sstream>

#include "fields/base/error.h"
#include "fields/base/given_file.h"
#include "ingest/apart/packed.h"
#include "ingest/grib/grib_file.h"

namespace slackwater::ingest {
namespace {

/// What a reader tells: what it read, or why it could not.
struct Told {
  bool is_read = false;
  ErrorKind kind = ErrorKind::internal;
  std::string text;  ///< the bytes, or the problem
};
template <typename Archive>
void serialize(Archive& archive, Told& told) {
  auto& [is_read, kind, text] = told;
  archive(is_read, kind, text);
}

Told told_by(const std::filesystem::path& file, const Allowance& allowance,
             const std::function<std::string(const TellShare&)>& read, const TellShare& tell) {
  try {
    return {true, {}, read(tell)};
  } catch (const Error& error) {
    return {false, error.kind(), error.message()};
  } catch (const std::bad_alloc&) {
    return {false, ErrorKind::invalid_input,
            "reading " + file.string() + " wants more than " +
                std::to_string(allowance.memory_bytes >> 30U) +
                " GB of memory: the file is damaged (fetch it again), or too large (cut it)"};
  } catch (const std::exception& fault) {
    return {false, ErrorKind::internal, "reading " + file.string() + ": " + fault.what()};
  }
}

std::string library_of(const std::filesystem::path& file) {
  std::error_code problem;
  if (!std::filesystem::is_regular_file(file, problem)) return "what reads it";
  return is_grib(file) ? "the GRIB library" : "the NetCDF library";
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

std::string read_apart(const std::filesystem::path& file, const Allowance& allowance,
                       const std::function<std::string(const TellShare&)>& read,
                       const std::function<void(double)>& on_share,
                       const std::function<void()>& meanwhile) {
  refuse_device(file);
  const Apart apart = run_apart(
      allowance,
      [&](const TellShare& tell) { return packed(told_by(file, allowance, read, tell)); }, on_share,
      meanwhile);
  if (apart.end != Apart::End::answered) throw error_of(apart, file, allowance);
  Told told = with_context(file.string(), [&] { return unpacked<Told>(apart.answer); });
  if (!told.is_read) throw Error(told.kind, told.text);
  return std::move(told.text);
}

}  // namespace slackwater::ingest
