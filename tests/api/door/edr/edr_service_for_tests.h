#pragma once
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "api/door/edr/service.h"
#include "tests/api/door/edr/made_up_store.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests {

using QueryPairs = std::vector<std::pair<std::string, std::string>>;

/// The routes of the EDR service over a store of made-up forecasts
/// (made_up_store.h), called without sockets.
class EdrServiceForTests {
 public:
  static constexpr const char* base = "http://edr.test";
  static constexpr const char* older = "lone_20250310T050000Z";
  static constexpr const char* newer = "lone_20250311T050000Z";

  EdrServiceForTests();

  /// Commits a forecast and lets the service see it.
  void issue(const Snapshot& snapshot);

  [[nodiscard]] api::http::Response get(const std::string& path, const QueryPairs& query = {},
                                        const std::string& accept = "") const;
  /// As sent on the wire: what stands behind the '?' is not encoded again.
  [[nodiscard]] api::http::Response get_raw(const std::string& path,
                                            const std::string& query) const;
  /// Whether it is left to the threads for long work; else it must be a 200.
  [[nodiscard]] bool takes_long(const std::string& path, const QueryPairs& query) const;
  /// What becomes of a query whose client leaves before its turn comes.
  [[nodiscard]] api::http::Response get_and_leave(const std::string& path,
                                                  const QueryPairs& query) const;
  /// The body of an answer that must be a 200.
  [[nodiscard]] nlohmann::json document(const std::string& path,
                                        const QueryPairs& query = {}) const;
  /// The sentence of a problem document, which the answer must be, with this status.
  [[nodiscard]] std::string refusal(int status, const std::string& path,
                                    const QueryPairs& query = {}) const;

  [[nodiscard]] std::shared_ptr<const Field> field(const std::string& instance) const {
    return forecasts_->field(instance);
  }
  /// The forecast in force of a site.
  [[nodiscard]] std::shared_ptr<const Field> in_force(const std::string& site) const;

 private:
  TemporaryFolder folder_;
  std::shared_ptr<api::IssuedFields> forecasts_;
  api::http::Router router_;
};

/// One service for all tests that only read.
[[nodiscard]] const EdrServiceForTests& edr_service();

inline constexpr const char* east_current = "eastward_sea_water_velocity";
inline constexpr const char* north_current = "northward_sea_water_velocity";

/// The values of a parameter in a CoverageJSON coverage.
[[nodiscard]] std::vector<double> values_of(const nlohmann::json& coverage,
                                            const std::string& name);

/// The numbers that a link list holds for a relation: how many links, all with a type.
[[nodiscard]] std::size_t links_with(const nlohmann::json& document, const std::string& relation);

}  // namespace slackwater::tests
