#include "ingest/apart/decode_apart.h"

#include "fields/base/error.h"
#include "ingest/apart/packed.h"
#include "ingest/apart/read_apart.h"

namespace slackwater {

template <typename Archive>
void serialize(Archive& archive, TimeCell& cell) {
  auto& [start, end] = cell;
  archive(start, end);
}
template <typename Archive>
void serialize(Archive& archive, Grid& grid) {
  auto& [time, vertical, levels_m, latitude_deg, longitude_deg] = grid;
  archive(time, vertical, levels_m, latitude_deg, longitude_deg);
}
template <typename Archive>
void serialize(Archive& archive, GranuleVariable& variable) {
  auto& [standard_name, unit, source_name, contains_stokes, has_status, has_tide] = variable;
  archive(standard_name, unit, source_name, contains_stokes, has_status, has_tide);
}
template <typename Archive>
void serialize(Archive& archive, Granule& granule) {
  auto& [grid, variables, is_point_series, station, water_depth_m, stated_error_m_s, status,
         reference_time, published_after, ensemble_member, product_id, dataset_id, attribution,
         is_regional] = granule;
  archive(grid, variables, is_point_series, station, water_depth_m, stated_error_m_s, status,
          reference_time, published_after, ensemble_member, product_id, dataset_id, attribution,
          is_regional);
}

namespace ingest {

/// As it is told: of a content file the name alone.
struct ToldGranule {
  Granule granule;
  std::string name;
};
template <typename Archive>
void serialize(Archive& archive, ToldGranule& told) {
  auto& [granule, name] = told;
  archive(granule, name);
}

struct ToldIngested {
  std::vector<ToldGranule> granules;
  std::vector<std::string> warnings;
  std::optional<UtcTime> published;
};
template <typename Archive>
void serialize(Archive& archive, ToldIngested& told) {
  auto& [granules, warnings, published] = told;
  archive(granules, warnings, published);
}

namespace {

std::string told_of(Ingested&& ingested) {
  ToldIngested told{{}, std::move(ingested.warnings), ingested.published};
  for (DecodedGranule& decoded : ingested.granules)
    told.granules.push_back({std::move(decoded.granule), decoded.content_file.filename().string()});
  return packed(told);
}

/// Whoever took the reader over may name what it likes: what is taken is a file of its folder.
std::filesystem::path content_file(const std::filesystem::path& staging_folder,
                                   const std::string& name) {
  std::filesystem::path file = staging_folder / name;
  std::error_code problem;
  const bool is_there =
      std::filesystem::path(name).filename() == name &&
      std::filesystem::symlink_status(file, problem).type() == std::filesystem::file_type::regular;
  if (!is_there) refuse("its reader named a content file that it did not write");
  return file;
}

}  // namespace

Ingested decode_apart(const std::filesystem::path& file, const ProductCatalogue& products,
                      const IngestOptions& options, const std::filesystem::path& staging_folder,
                      const Progress& progress, const std::function<void()>& meanwhile) {
  Allowance allowance = allowance_for(file);
  allowance.reach.writable = {staging_folder};
  const std::string bytes = read_apart(
      file, allowance,
      [&](const TellShare& tell) {
        return told_of(decode_file(file, products, options, staging_folder, tell));
      },
      progress, meanwhile);
  return with_context(context_of_told(file), [&] {
    auto told = unpacked<ToldIngested>(bytes);
    Ingested ingested{{}, std::move(told.warnings), told.published};
    for (ToldGranule& one : told.granules) {
      expect_canonical(one.granule.grid);
      if (one.granule.status > DataStatus::observation || one.granule.variables.empty())
        refuse("its reader told of a granule that is none");
      ingested.granules.push_back({std::move(one.granule), content_file(staging_folder, one.name)});
    }
    if (ingested.granules.empty()) refuse("its reader found nothing, and did not say why");
    return ingested;
  });
}

}  // namespace ingest
}  // namespace slackwater
