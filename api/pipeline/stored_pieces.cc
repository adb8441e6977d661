#include "api/pipeline/stored_pieces.h"

#include <algorithm>
#include <set>

#include "ingest/pieces.h"

namespace slackwater::api {
namespace {

/// Damaged files that are told one by one; the rest are counted.
constexpr std::size_t most_told = 3;

/// The store's granules, those alone whose content files are whole.
class WholeGranules {
 public:
  explicit WholeGranules(store::Store& store) : store_(store) {}

  /// In catalogue order.
  std::vector<ingest::GranuleEntry> find(const std::vector<std::string>& standard_names,
                                         const ingest::CutOut& window) {
    store::GranuleQuery query;
    query.any_of = standard_names;
    query.from = window.from;
    query.to = window.to;
    query.box = window.box;
    query.margin_km = ingest::farthest_granule_km;
    std::vector<ingest::GranuleEntry> found;
    for (const store::GranuleRow& row : store_.find_granules(query)) {
      if (!ingest::comes_near(row.is_point_series, row.bounds, row.standard_names, window))
        continue;
      if (!is_whole(row)) continue;
      found.push_back({row.id, row.source_sha256, row.product_id, row.standard_names,
                       store_.content_path(row.content_sha256), row.ingested_at, row.published_at});
    }
    return found;
  }

  [[nodiscard]] std::vector<DamagedFile> damaged() && { return std::move(damaged_); }

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
  std::vector<DamagedFile> damaged_;
};

}  // namespace

StoredPieces stored_pieces(store::Store& store, const Site& site, UtcTime from, UtcTime to) {
  WholeGranules granules(store);
  StoredPieces found;
  found.pieces =
      ingest::pieces_of(site, from, to, [&](const auto& standard_names, const auto& window) {
        return granules.find(standard_names, window);
      });
  found.damaged = std::move(granules).damaged();
  return found;
}

std::vector<store::GranuleRow> near_site(std::vector<store::GranuleRow> granules,
                                         const Site& site) {
  const ingest::CutOut window{std::nullopt, std::nullopt, site.box(0), site.box(0)};
  std::erase_if(granules, [&](const store::GranuleRow& row) {
    return !ingest::comes_near(row.is_point_series, row.bounds, row.standard_names, window);
  });
  return granules;
}

std::string text_of(const std::vector<DamagedFile>& damaged) {
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

}  // namespace slackwater::api
