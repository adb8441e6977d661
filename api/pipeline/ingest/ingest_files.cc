#include "api/pipeline/ingest/ingest_files.h"

#include <algorithm>
#include <array>
#include <future>

#include "data/store/staging.h"
#include "fields/base/encode/sha256.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "ingest/apart/decode_apart.h"
#include "ingest/copernicus/product.h"
#include "ingest/publication.h"

namespace slackwater::api {
namespace {

/// The cut is part of a source's identity: the same file cut otherwise is another source.
std::string cut_key(const ingest::IngestOptions& options) {
  std::string key;
  if (options.cut) {
    key += formatted("bbox={:.6f},{:.6f},{:.6f},{:.6f};", options.cut->west_deg,
                     options.cut->south_deg, options.cut->east_deg, options.cut->north_deg);
  }
  if (options.as) key += "as=" + std::string(name_of(*options.as)) + ";";
  if (options.issued) key += "issued=" + format_utc(*options.issued) + ";";
  if (options.product)
    key += "product=" + options.product->id + "@" + options.product->sha256.substr(0, 12) + ";";
  return key;
}

store::NewGranule to_row(const ingest::DecodedGranule& decoded) {
  const Granule& granule = decoded.granule;
  store::GranuleRow row;
  for (const GranuleVariable& variable : granule.variables) {
    row.standard_names.push_back(variable.standard_name);
    row.contains_stokes = row.contains_stokes || variable.contains_stokes;
  }
  row.is_point_series = granule.is_point_series;
  row.station = granule.station;
  row.status = granule.status;
  row.reference_time = granule.reference_time;
  row.ensemble_member = granule.ensemble_member;
  if (!granule.grid.time.empty()) {
    row.first_time = granule.grid.time.front().start;
    row.last_time = granule.grid.time.back().end;
  }
  row.times = granule.grid.time.size();
  row.bounds = coverage_of(granule.grid);
  row.vertical = granule.grid.vertical;
  if (!granule.grid.levels_m.empty()) {
    row.lowest_level_m = granule.grid.levels_m.front();
    row.highest_level_m = granule.grid.levels_m.back();
  }
  row.product_id = granule.product_id;
  row.dataset_id = granule.dataset_id;
  row.attribution = granule.attribution;
  return {std::move(row), decoded.content_file};
}

bool is_product_file(const std::filesystem::path& file) {
  static constexpr std::array<std::string_view, 7> endings{".nc",    ".nc4", ".cdf", ".grib",
                                                           ".grib2", ".grb", ".grb2"};
  return std::find(endings.begin(), endings.end(), file.extension().string()) != endings.end();
}

store::SourceFile source_of(const std::filesystem::path& file, const ingest::IngestOptions& options,
                            UtcTime now) {
  std::error_code problem;
  if (!std::filesystem::is_regular_file(file, problem)) {
    throw Error(ErrorKind::not_found, "found no file " + file.string() + "; check the path");
  }
  store::SourceFile source;
  source.cut_key = cut_key(options);
  source.name = file.filename().string();
  source.bytes = std::filesystem::file_size(file);
  source.ingested_at = now;
  return source;
}

/// Small files are hashed first: a file that is there already then costs no decoding. Large ones
/// are hashed while they are decoded, which keeps both cores busy.
bool is_hashed_first(const store::SourceFile& source) { return source.bytes <= (64U << 20U); }

std::optional<IngestReport> report_if_known(store::Store& store, const store::SourceFile& source,
                                            const std::filesystem::path& file) {
  const auto known = store.find_source(source.sha256, source.cut_key);
  if (!known) return std::nullopt;
  IngestReport report;
  report.file = file;
  report.sha256 = source.sha256;
  report.product_id = known->product_id;
  return report;
}

/// Names become links and headers, whatever a file has in their place.
void expect_names(const store::GranuleRow& row, const std::filesystem::path& file) {
  for (const std::string& name : {row.station, row.product_id, row.dataset_id})
    if (name.size() > store::longest_name_bytes)
      refuse(
          formatted("{}: found the name of a station, product or dataset with {} bytes, expected "
                    "at most {}; the file is damaged: fetch it again",
                    file.string(), name.size(), store::longest_name_bytes));
}

IngestReport commit(store::Store& store, store::SourceFile source, ingest::Ingested ingested,
                    const std::filesystem::path& file) {
  IngestReport report;
  report.file = file;
  std::vector<store::NewGranule> granules;
  for (const ingest::DecodedGranule& decoded : ingested.granules) {
    granules.push_back(to_row(decoded));
    expect_names(granules.back().row, file);
    for (const GranuleVariable& variable : decoded.granule.variables) {
      if (std::find(report.standard_names.begin(), report.standard_names.end(),
                    variable.standard_name) == report.standard_names.end()) {
        report.standard_names.push_back(variable.standard_name);
      }
    }
  }
  report.counts = counts_of(ingested.granules);
  const Granule& first = ingested.granules.front().granule;
  source.product_id = first.product_id;
  source.dataset_id = first.dataset_id;
  source.attribution = first.attribution;
  source.published_at = ingest::published_by(ingested.published, source.ingested_at);
  source.warnings = ingested.warnings;
  report.status = name_of(first.status);
  const bool was_there = store.names_source(source.sha256, source.cut_key);
  report.stored = store.commit_ingest(source, granules);
  report.repaired = report.stored && was_there;
  report.sha256 = source.sha256;
  report.product_id = source.product_id;
  report.granules = granules.size();
  report.warnings = std::move(ingested.warnings);
  return report;
}

/// Between two readers, each of which is a copy of this process.
store::Store open_for_a_while(const std::filesystem::path& folder) {
  store::Store store = store::Store::open(folder, store::OpenMode::create_or_write);
  store.leave_log();
  return store;
}

}  // namespace

IngestReport ingest_file(store::Store& store, const ingest::ProductCatalogue& products,
                         const std::filesystem::path& file, const ingest::IngestOptions& options,
                         UtcTime now, const ingest::Progress& progress) {
  store::SourceFile source = source_of(file, options, now);
  std::future<std::string> hash;
  if (is_hashed_first(source)) {
    source.sha256 = sha256_of_file(file);
    if (auto known = report_if_known(store, source, file)) return *known;
  } else {
    hash = std::async(std::launch::async, [file] { return sha256_of_file(file); });
  }
  ingest::Ingested ingested =
      ingest::decode_file(file, products, options, store.staging_folder(), progress);
  if (hash.valid()) source.sha256 = hash.get();
  return commit(store, std::move(source), std::move(ingested), file);
}

IngestReport ingest_file_apart(const std::filesystem::path& store_folder,
                               const ingest::ProductCatalogue& products,
                               const std::filesystem::path& file,
                               const ingest::IngestOptions& options, UtcTime now,
                               const ingest::Progress& progress) {
  store::SourceFile source = source_of(file, options, now);
  if (is_hashed_first(source)) {
    source.sha256 = sha256_of_file(file);
    store::Store store = open_for_a_while(store_folder);
    if (auto known = report_if_known(store, source, file)) return *known;
  }
  const auto staging = store::StagingFolder::make(store_folder);
  ingest::Ingested ingested =
      ingest::decode_apart(file, products, options, staging.path(), progress, [&] {
        if (source.sha256.empty()) source.sha256 = sha256_of_file(file);
      });
  store::Store store = open_for_a_while(store_folder);
  return commit(store, std::move(source), std::move(ingested), file);
}

std::vector<std::filesystem::path> product_files(const std::vector<std::filesystem::path>& paths) {
  std::vector<std::filesystem::path> files;
  for (const auto& path : paths) {
    std::error_code problem;
    if (!std::filesystem::is_directory(path, problem)) {
      if (!std::filesystem::exists(path, problem)) {
        throw Error(ErrorKind::not_found, "found no file " + path.string() + "; check the path");
      }
      files.push_back(path);
      continue;
    }
    std::vector<std::filesystem::path> inside;
    auto entries = std::filesystem::recursive_directory_iterator(path);
    for (auto it = begin(entries); it != end(entries); ++it) {
      const std::filesystem::directory_entry& entry = *it;
      // What `fetch` has not looked into yet lies in a hidden folder.
      if (entry.path().filename().string().starts_with(".")) {
        if (entry.is_directory()) it.disable_recursion_pending();
        continue;
      }
      if (entry.is_regular_file() && is_product_file(entry.path())) inside.push_back(entry.path());
    }
    if (inside.empty()) {
      throw Error(ErrorKind::not_found,
                  "found no product files (.nc, .grib …) below " + path.string());
    }
    std::sort(inside.begin(), inside.end());
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

}  // namespace slackwater::api
