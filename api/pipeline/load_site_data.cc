#include "api/pipeline/load_site_data.h"

#include <algorithm>
#include <set>

#include "api/pipeline/held_data.h"
#include "fields/base/error.h"
#include "fields/base/log.h"
#include "ingest/pieces.h"

namespace slackwater::api {
namespace {

/// Damaged files that are told one by one; the rest are counted.
constexpr std::size_t most_told = 3;

/// A granule whose content file cannot be opened.
struct Damaged {
  std::string product;
  std::string name;  ///< of the product file it came from
  std::string content_file;
  std::string fault;
};

/// The store's granules around a site, those alone whose content files are whole.
class WholeGranules {
 public:
  explicit WholeGranules(store::Store& store) : store_(store) {}

  /// In catalogue order.
  std::vector<ingest::GranuleEntry> find(const std::vector<std::string>& standard_names,
                                         const ingest::Window& window) {
    store::GranuleQuery query;
    query.any_of = standard_names;
    query.from = window.from;
    query.to = window.to;
    query.box = window.box;
    query.margin_km = ingest::granule_margin_km;
    std::vector<ingest::GranuleEntry> found;
    for (const store::GranuleRow& row : store_.find_granules(query)) {
      if (is_whole(row)) {
        found.push_back({row.id, row.source_sha256, row.product_id, row.standard_names,
                         store_.content_path(row.content_sha256), row.ingested_at});
      }
    }
    return found;
  }

  [[nodiscard]] const std::vector<Damaged>& damaged() const noexcept { return damaged_; }

 private:
  bool is_whole(const store::GranuleRow& row) {
    const auto fault = store_.content_fault(row.content_sha256);
    if (!fault) return true;
    if (known_.insert(row.content_sha256).second) {
      damaged_.push_back({row.product_id, name_of_source(row),
                          store_.content_path(row.content_sha256).string(), *fault});
    }
    return false;
  }

  std::string name_of_source(const store::GranuleRow& row) const {
    for (const store::SourceFile& source : store_.list_sources()) {
      if (source.sha256 == row.source_sha256 && source.cut_key == row.cut_key) return source.name;
    }
    return row.content_sha256.substr(0, 12);
  }

  store::Store& store_;
  std::set<std::string> known_;
  std::vector<Damaged> damaged_;
};

/// "the stored copy of waves.nc (PRODUCT) is damaged and left out: ingest it again, see `slackwater
/// store check`"
std::string text_of(const std::vector<Damaged>& damaged) {
  if (damaged.empty()) return {};
  std::string text = damaged.size() == 1 ? "the stored copy of " : "the stored copies of ";
  for (std::size_t i = 0; i < std::min(damaged.size(), most_told); ++i)
    text += (i > 0 ? ", " : "") + damaged[i].name + " (" + damaged[i].product + ")";
  if (damaged.size() > most_told)
    text += " and " + std::to_string(damaged.size() - most_told) + " more";
  text += damaged.size() == 1 ? " is damaged and left out: ingest it again"
                              : " are damaged and left out: ingest them again";
  return text + ", see `slackwater store check`";
}

/// What the store holds for the site in a window of time, perhaps nothing; damage is logged.
SiteData data_of(store::Store& store, const Site& site, UtcTime from, UtcTime to) {
  WholeGranules granules(store);
  SitePieces pieces =
      ingest::pieces_of(site, from, to, [&](const auto& standard_names, const auto& window) {
        return granules.find(standard_names, window);
      });
  for (const Damaged& file : granules.damaged()) {
    log_event(LogLevel::warning, "stored file left out",
              {{"name", file.name},
               {"product", file.product},
               {"content_file", file.content_file},
               {"problem", file.fault}});
  }
  SiteData data = site_data_of(site, std::move(pieces));
  data.damage = text_of(granules.damaged());
  return data;
}

}  // namespace

SiteData load_site_data(store::Store& store, const Site& site, UtcTime from, UtcTime to) {
  SiteData data = data_of(store, site, from, to);
  if (data.is_empty()) {
    const bool is_damaged = !data.damage.empty();
    throw Error(
        is_damaged ? ErrorKind::invalid_input : ErrorKind::not_found,
        "the store holds nothing for site " + site.id + " at " + position_text(site.point) +
            " from " + format_utc(from) + " to " + format_utc(to) +
            (is_damaged ? " that can be read: " + data.damage : "; " + held_text(store, site)));
  }
  return data;
}

std::optional<double> bathymetry_at(store::Store& store, const Site& site) {
  Site point = site;
  point.water_depth_m.reset();
  point.columns.clear();
  point.column_block.reset();
  const UtcTime before_all{};  // static fields are in every window, all else is in none of this one
  const SiteData data = data_of(store, point, before_all, before_all);
  const WaterDepth& depth = data.columns.front().water_depth;
  if (depth.source != "bathymetry") return std::nullopt;
  return depth.depth_m;
}

}  // namespace slackwater::api
