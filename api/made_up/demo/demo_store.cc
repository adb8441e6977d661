#include "api/made_up/demo/demo_store.h"

#include <map>
#include <vector>

#include "api/made_up/demo/demo_run.h"
#include "data/store/store.h"
#include "fields/base/encode/sha256.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

bool is_demos(const store::ForecastRow& row) {
  return row.site_id == demo_site_id && row.origin == ForecastOrigin::forecast &&
         row.issued == demo_issue_time(row.day);
}

/// "2 forecasts of saint_brieuc, 1 forecast of here".
std::string forecasts_by_site(const std::vector<store::ForecastRow>& rows) {
  std::map<std::string, std::size_t> count;
  for (const store::ForecastRow& row : rows) ++count[row.site_id];
  std::vector<std::string> parts;
  parts.reserve(count.size());
  for (const auto& [site, n] : count) parts.push_back(counted(n, "forecast") + " of " + site);
  return parts.empty() ? "no forecasts" : joined(parts, ", ");
}

std::vector<std::string> site_files(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "sites", ignored))
    names.push_back(entry.path().filename().string());
  return names;
}

/// The winds of the ocean are GRIB, which cannot say that they are made up: they are known by the
/// files that they were read from.
bool is_demos(const store::SourceFile& source, const std::filesystem::path& products) {
  if (source.product_id == demo_product) return true;
  const std::filesystem::path file = products / std::filesystem::path(source.name).filename();
  return std::filesystem::is_regular_file(file) && sha256_of_file(file) == source.sha256;
}

StoreInTheWay look_inside(const std::filesystem::path& folder,
                          const std::filesystem::path& products) {
  StoreInTheWay found;
  found.is_there = true;
  store::Store store = store::Store::open(folder, store::OpenMode::read_only);
  const std::vector<store::ForecastRow> forecasts = store.list_forecasts();
  const std::vector<store::SourceFile> sources = store.list_sources();
  const std::vector<std::string> sites = site_files(folder);
  found.holds = forecasts_by_site(forecasts) + "; " +
                counted(store.find_granules({}).size(), "granule") + " of " +
                counted(sources.size(), "product file");
  if (!sites.empty()) found.holds += "; the site files " + joined(sites, ", ");
  std::vector<std::string> others;
  std::vector<store::ForecastRow> own;
  for (const store::ForecastRow& row : forecasts)
    if (!is_demos(row)) own.push_back(row);
  if (!own.empty()) others.push_back(forecasts_by_site(own));
  std::size_t files = 0;
  for (const store::SourceFile& source : sources) files += is_demos(source, products) ? 0 : 1;
  if (files > 0) others.push_back(counted(files, "product file"));
  for (const std::string& name : sites)
    if (name != std::string(demo_site_id) + ".yaml") others.push_back("the site file " + name);
  found.not_demos = joined(others, ", ");
  return found;
}

}  // namespace

StoreInTheWay look_at_demo_store(const std::filesystem::path& folder) {
  const std::filesystem::path store = folder / "store";
  StoreInTheWay found;
  if (!std::filesystem::exists(store)) return found;
  if (std::filesystem::is_directory(store) && std::filesystem::is_empty(store)) return found;
  if (!std::filesystem::exists(store / "catalogue.sqlite")) {
    found.is_there = true;
    found.is_store = false;
    return found;
  }
  try {
    return look_inside(store, folder / "products");
  } catch (const Error& problem) {
    found.is_there = true;
    found.holds = "a store that cannot be read (" + problem.message() + ")";
    found.not_demos = found.holds;
  }
  return found;
}

void clear_demo_store(const std::filesystem::path& folder, const StoreInTheWay& found, bool force) {
  if (!found.is_there) return;
  const std::filesystem::path store = folder / "store";
  if (!found.is_store) {
    throw Error(ErrorKind::usage, "found " + store.string() +
                                      ", which is no store of Slackwater; the demonstration would "
                                      "write its store there; choose another --out");
  }
  if (!found.not_demos.empty() && !force) {
    throw Error(ErrorKind::usage,
                "found a store at " + store.string() +
                    " that holds what no demonstration made: " + found.not_demos +
                    "; choose another --out, or say --force to delete all of it (" + found.holds +
                    ")");
  }
  std::filesystem::remove_all(store);
}

}  // namespace slackwater::api
