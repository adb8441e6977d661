#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "api/ask/plan/plan_file.h"
#include "api/ask/windows/windows.h"
#include "api/issued/site_state.h"

// What the commands answer of a site, asked in a query: the same values, the same JSON.

namespace slackwater::api::desk {

/// The water and the past mornings of the last forecast that was asked about, so that the next
/// question about it reads no file. Thread-safe.
class WaterAtHand {
 public:
  /// Fills what is known of the question's site where nothing else was asked of its forecast.
  void lend(const std::string& mark, WindowsQuestion& question) const;
  void keep(const std::string& mark, const WindowsQuestion& question, const WindowsAnswer& answer);

 private:
  mutable std::mutex mutex_;
  std::string mark_, site_;
  std::optional<ScenarioWater> water_;
  std::shared_ptr<const PastOutlooks> past_;
};

/// What the answers come from.
struct Answers {
  std::filesystem::path store_folder, data_folder;
  std::function<UtcTime()> now;
  bool by_clock = true;  ///< `now` is the machine's clock, and not one that somebody set
  std::shared_ptr<WaterAtHand> water = std::make_shared<WaterAtHand>();
};

/// `slackwater windows --site SITE --json` with the words of the query.
[[nodiscard]] nlohmann::json windows_answer(const Answers& from, const std::string& site,
                                            const std::string& query);
/// `slackwater report --site SITE --json`, nothing flown and without the page's place.
[[nodiscard]] nlohmann::json report_answer(const Answers& from, const std::string& site,
                                           const std::string& query);
/// `slackwater plan STORE/plans/SITE.yaml --json`. Words: chance, time-limit (s), assume.
/// @throws Error(not_found) where the site has no plan
[[nodiscard]] nlohmann::json plan_answer(const Answers& from, const std::string& site,
                                         const std::string& query);
/// `slackwater verify --site SITE --json`. Words: from, to, bands.
[[nodiscard]] nlohmann::json verification_answer(const Answers& from, const std::string& site,
                                                 const std::string& query);
/// `slackwater site sources SITE --json`. Words: day, horizon, wind.
[[nodiscard]] nlohmann::json sources_answer(const Answers& from, const std::string& site,
                                            const std::string& query);
/// `slackwater decisions --site SITE --json`. Words: task, from.
[[nodiscard]] nlohmann::json decisions_answer(const Answers& from, const std::string& site,
                                              const std::string& query);

/// The plan that a file and the windows of a question make.
/// @param flown  see `windows_for_plan`
[[nodiscard]] nlohmann::json plan_of(const Answers& from, const PlanFile& file,
                                     WindowsQuestion question, double chance, double limit_s);

}  // namespace slackwater::api::desk
