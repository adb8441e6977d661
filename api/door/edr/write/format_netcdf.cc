#include "api/door/edr/write/format_netcdf.h"

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>
#include <vector>

#include "api/door/edr/write/merged_coverage.h"
#include "api/program/version.h"
#include "fields/base/error.h"
#include "fields/base/log.h"
#include "fields/base/text.h"

namespace slackwater::api::edr {
namespace {

/// A folder that nobody else can enter, and that goes with its owner.
class PrivateFolder {
 public:
  PrivateFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "slackwater-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
      throw Error(ErrorKind::unavailable, "cannot make the folder " + name +
                                              " for an answer; check free space and permissions");
    }
    path_ = name;
  }
  ~PrivateFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;
  const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_;
};

/// Empty attributes are not CF: "none" stands for nothing to say.
std::string or_none(std::string text) { return text.empty() ? "none" : std::move(text); }

std::vector<std::pair<std::string, std::string>> attributes_of(const Answer& answer) {
  const Provenance& from = answer.provenance;
  if (from.product) {
    return {{"title", or_none(answer.title)},
            {"institution", "Slackwater"},
            {"source", "product " + from.product->product_id + " as stored"},
            {"history", "cut out by Slackwater"},
            {"references", or_none(joined(from.attributions, "\n"))},
            {"comment", or_none(joined(answer.notes, "\n"))},
            {"slackwater_collection", or_none(answer.collection)},
            {"slackwater_product", or_none(from.product->product_id)},
            {"slackwater_dataset", or_none(from.product->dataset_id)},
            {"slackwater_runs", or_none(joined(from.product->runs, "\n"))},
            {"slackwater_sources_sha256", or_none(joined(from.product->sources, "\n"))},
            {"slackwater_attributions", or_none(joined(from.attributions, "\n"))},
            {"slackwater_code_version", code_version()}};
  }
  return {{"title", or_none(answer.title)},
          {"institution", "Slackwater"},
          {"source", "Slackwater forecast " + from.instance},
          {"history", format_utc(from.issued) + " issued by Slackwater"},
          {"references", or_none(joined(from.attributions, "\n"))},
          {"comment", or_none(joined(answer.notes, "\n"))},
          {"slackwater_site_id", or_none(from.site_id)},
          {"slackwater_collection", or_none(answer.collection)},
          {"slackwater_instance", or_none(from.instance)},
          {"slackwater_issued", format_utc(from.issued)},
          {"slackwater_day", format_day(from.day)},
          {"slackwater_headline", or_none(from.headline)},
          {"slackwater_degraded", from.degraded ? "true" : "false"},
          {"slackwater_attributions", or_none(joined(from.attributions, "\n"))},
          {"slackwater_code_version", or_none(from.code_version)}};
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream || bytes.empty()) {
    throw Error(ErrorKind::unavailable, "cannot read " + file.string() + " back");
  }
  return bytes;
}

/// The bytes of the file. Clients are not told of the server's folders: those stand in its log.
std::string written(const ingest::SampledFile& file) {
  try {
    const PrivateFolder folder;
    const std::filesystem::path path = folder.path() / "answer.nc";
    ingest::write_coverage(path, file);
    return bytes_of(path);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::unavailable) throw;
    log_event(LogLevel::error, "answer cannot be written", {{"problem", error.message()}});
    throw Error(ErrorKind::unavailable,
                "the server cannot write a NetCDF answer now; ask again later, or for another f");
  }
}

}  // namespace

std::string netcdf(const Answer& answer) {
  if (answer.coverages.empty()) {
    throw Error(ErrorKind::not_found,
                "nothing of '" + answer.collection +
                    "' lies in the area asked for; a NetCDF answer holds one place at least");
  }
  ingest::SampledFile file = merged_coverage(answer);
  file.global_attributes = attributes_of(answer);
  if (!answer.provenance.product)
    file.reference_time = UtcTime(answer.provenance.day) + std::chrono::days(1);
  return written(file);
}

}  // namespace slackwater::api::edr
