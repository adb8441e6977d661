#include "ingest/read_pieces.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <tuple>

#include "fields/base/encode/sha256.h"
#include "fields/base/error.h"
#include "fields/geo/coverage.h"
#include "ingest/pieces.h"
#include "ingest/publication.h"

namespace slackwater::ingest {
namespace {

Error cannot_make(const std::filesystem::path& folder, const std::string& why) {
  return {ErrorKind::unavailable,
          "cannot make the folder " + folder.string() + ": " + why +
              "; make room there, or point TMPDIR at a folder that can be written"};
}

/// A fresh folder that goes with its owner.
class StagingFolder {
 public:
  StagingFolder() {
    std::error_code problem;
    const auto folder = std::filesystem::temp_directory_path(problem);
    std::string name = (folder / "slackwater-XXXXXX").string();
    if (problem || mkdtemp(name.data()) == nullptr) {
      throw cannot_make(name, problem ? problem.message() : std::strerror(errno));
    }
    path_ = name;
  }
  ~StagingFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  StagingFolder(const StagingFolder&) = delete;
  StagingFolder& operator=(const StagingFolder&) = delete;

  /// A folder of its own for the granules of one file: their names repeat from file to file.
  [[nodiscard]] std::filesystem::path for_file(std::size_t index) const {
    auto folder = path_ / std::to_string(index);
    std::error_code problem;
    std::filesystem::create_directory(folder, problem);
    if (problem) throw cannot_make(folder, problem.message());
    return folder;
  }

 private:
  std::filesystem::path path_;
};

/// A granule and what a search asks of it.
struct ListedGranule {
  GranuleEntry entry;
  std::optional<UtcTime> first_time;  ///< absent for a static field
  std::optional<UtcTime> last_time;
  std::string status;
  std::optional<UtcTime> reference_time;
  std::optional<int> ensemble_member;
  BoundingBox bounds;
  bool is_point_series = false;
};

ListedGranule listed(const DecodedGranule& decoded, std::int64_t number,
                     const std::string& source_sha256, const std::optional<UtcTime>& received,
                     const std::optional<UtcTime>& published) {
  const Granule& granule = decoded.granule;
  ListedGranule result;
  result.entry = {number,   source_sha256, granule.product_id, {}, decoded.content_file,
                  received, published};
  for (const GranuleVariable& variable : granule.variables)
    result.entry.standard_names.push_back(variable.standard_name);
  if (!granule.grid.time.empty()) {
    result.first_time = granule.grid.time.front().start;
    result.last_time = granule.grid.time.back().end;
  }
  result.status = name_of(granule.status);
  result.reference_time = granule.reference_time;
  result.ensemble_member = granule.ensemble_member;
  result.bounds = coverage_of(granule.grid);
  result.is_point_series = granule.is_point_series;
  return result;
}

/// Catalogue order: see `FindGranules`.
bool stands_before(const ListedGranule& a, const ListedGranule& b) {
  const auto key = [](const ListedGranule& g) {
    return std::tie(g.first_time, g.status, g.reference_time, g.ensemble_member, g.entry.number);
  };
  return key(a) < key(b);
}

bool holds_any(const ListedGranule& granule, const std::vector<std::string>& standard_names) {
  const std::vector<std::string>& held = granule.entry.standard_names;
  return std::find_first_of(held.begin(), held.end(), standard_names.begin(),
                            standard_names.end()) != held.end();
}

bool touches(const ListedGranule& granule, const CutOut& window) {
  if (window.from && granule.last_time && *granule.last_time < *window.from) return false;
  if (window.to && granule.first_time && *granule.first_time > *window.to) return false;
  return comes_near(granule.is_point_series, granule.bounds, granule.entry.standard_names, window);
}

/// What tells a source from another: the same bytes read otherwise are another one.
struct SourceKey {
  std::string sha256;
  std::optional<BoundingBox> cut;
  std::optional<DataStatus> as;
  std::optional<UtcTime> issued;
  bool operator==(const SourceKey&) const = default;
};

}  // namespace

ReadPieces read_pieces(std::span<const FileToRead> files, const ProductCatalogue& products,
                       const Site& site, UtcTime from, UtcTime to) {
  const StagingFolder staging;
  ReadPieces result;
  std::vector<ListedGranule> granules;
  std::vector<SourceKey> known;
  for (const FileToRead& file : files) {
    std::error_code problem;
    if (!std::filesystem::is_regular_file(file.path, problem)) {
      throw Error(ErrorKind::not_found, "found no file " + file.path.string() + "; check the path");
    }
    const SourceKey source{sha256_of_file(file.path), file.options.cut, file.options.as,
                           file.options.issued};
    if (std::find(known.begin(), known.end(), source) != known.end()) continue;
    known.push_back(source);
    const Ingested ingested =
        decode_file(file.path, products, file.options, staging.for_file(known.size()));
    const auto published = published_by(ingested.published, file.received);
    for (const DecodedGranule& decoded : ingested.granules) {
      const auto number = static_cast<std::int64_t>(granules.size() + 1);
      granules.push_back(listed(decoded, number, source.sha256, file.received, published));
    }
    for (const std::string& warning : ingested.warnings)
      result.warnings.push_back(file.path.filename().string() + ": " + warning);
  }
  std::sort(granules.begin(), granules.end(), stands_before);
  result.pieces = pieces_of(
      site, from, to, [&](const std::vector<std::string>& standard_names, const CutOut& window) {
        std::vector<GranuleEntry> found;
        for (const ListedGranule& granule : granules) {
          if (holds_any(granule, standard_names) && touches(granule, window))
            found.push_back(granule.entry);
        }
        return found;
      });
  return result;
}

}  // namespace slackwater::ingest
