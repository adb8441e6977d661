#include "api/pipeline/ingest/ingest_apart.h"

#include <new>
#include <nlohmann/json.hpp>

#include "data/store/staging.h"
#include "fields/base/check.h"
#include "ingest/grib/grib_file.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

// --- what the child says ---

json to_json(const IngestReport& report) {
  return {{"stored", report.stored},
          {"repaired", report.repaired},
          {"sha256", report.sha256},
          {"product", report.product_id},
          {"granules", report.granules},
          {"times", report.counts.times},
          {"times_by_status", report.counts.by_status},
          {"members", report.counts.members},
          {"standard_names", report.standard_names},
          {"status", report.status},
          {"warnings", report.warnings}};
}

std::string out_of_memory(const std::filesystem::path& file, const Allowance& allowance) {
  return "reading " + file.string() + " wants more than " +
         std::to_string(allowance.memory_bytes >> 30U) +
         " GB of memory: the file is damaged (fetch it again), or too large (give a smaller "
         "--bbox)";
}

// --- what is made of it ---

IngestReport report_of(const json& answer, const std::filesystem::path& file) {
  IngestReport report;
  report.file = file;
  report.stored = answer.at("stored").get<bool>();
  report.repaired = answer.at("repaired").get<bool>();
  report.sha256 = answer.at("sha256").get<std::string>();
  report.product_id = answer.at("product").get<std::string>();
  report.granules = answer.at("granules").get<std::size_t>();
  report.counts.times = answer.at("times").get<std::size_t>();
  report.counts.by_status = answer.at("times_by_status").get<std::map<std::string, std::size_t>>();
  report.counts.members = answer.at("members").get<std::size_t>();
  report.standard_names = answer.at("standard_names").get<std::vector<std::string>>();
  report.status = answer.at("status").get<std::string>();
  report.warnings = answer.at("warnings").get<std::vector<std::string>>();
  return report;
}

bool looks_like_grib(const std::filesystem::path& file) {
  std::error_code problem;
  return std::filesystem::is_regular_file(file, problem) && ingest::is_grib(file);
}

}  // namespace

Allowance allowance_for(const std::filesystem::path& file) {
  Allowance allowance;
  std::error_code problem;
  const std::uintmax_t bytes = std::filesystem::file_size(file, problem);
  if (!problem) allowance.processor += std::chrono::minutes(bytes >> 30U);
  return allowance;
}

json problem_json(ErrorKind kind, const std::string& message) {
  return {{"kind", static_cast<int>(kind)}, {"problem", message}};
}

Error error_of(const Apart& apart, const std::filesystem::path& file, const Allowance& allowance) {
  expects(apart.end != Apart::End::answered, "what answered is no error");
  const std::string library = looks_like_grib(file) ? "the GRIB library" : "the NetCDF library";
  const std::string how =
      apart.signal == 0 ? "it ended without an answer" : "signal " + std::to_string(apart.signal);
  switch (apart.end) {
    case Apart::End::out_of_time:
      return {ErrorKind::invalid_input,
              "reading " + file.string() + " took " + library + " more than " +
                  std::to_string(allowance.processor.count()) +
                  " s of processor time: the file is damaged; fetch it again"};
    case Apart::End::killed:
      return {ErrorKind::unavailable,
              "reading " + file.string() + " was ended from outside (" + how +
                  "); if the system was short of memory give a smaller --bbox, else run it again"};
    default:
      return {ErrorKind::invalid_input, "reading " + file.string() + " crashed " + library + " (" +
                                            how + "): the file is damaged; fetch it again"};
  }
}

IngestReport ingest_file_apart(const std::filesystem::path& store_folder,
                               const ingest::ProductCatalogue& products,
                               const std::filesystem::path& file,
                               const ingest::IngestOptions& options, UtcTime now,
                               const ingest::Progress& progress) {
  const Allowance allowance = allowance_for(file);
  const auto read = [&](const TellShare& tell) {
    json answer;
    try {
      store::Store store = store::Store::open(store_folder, store::OpenMode::create_or_write);
      store.leave_log();
      answer = to_json(ingest_file(store, products, file, options, now, tell));
    } catch (const Error& error) {
      answer = problem_json(error.kind(), error.message());
    } catch (const std::bad_alloc&) {
      answer = problem_json(ErrorKind::invalid_input, out_of_memory(file, allowance));
    } catch (const std::exception& fault) {
      answer = problem_json(ErrorKind::internal, "reading " + file.string() + ": " + fault.what());
    }
    return answer.dump(-1, ' ', false, json::error_handler_t::replace);
  };
  const Apart apart = run_apart(allowance, read, progress);
  if (apart.end != Apart::End::answered) {
    store::sweep_staging(store_folder);  // what it had begun
    throw error_of(apart, file, allowance);
  }
  const json answer = json::parse(apart.answer);
  if (answer.contains("problem")) {
    throw Error(static_cast<ErrorKind>(answer.at("kind").get<int>()),
                answer.at("problem").get<std::string>());
  }
  return report_of(answer, file);
}

}  // namespace slackwater::api
