#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "api/ask/morning/morning.h"
#include "api/pipeline/past_skill.h"
#include "api/show/report/forecast_page.h"

namespace slackwater::api {

/// What is known of a forecast beside its numbers.
struct KnownForecast {
  std::optional<calibration::ForecastMaking> making;  ///< absent: not of the store
  PastSkill past;
};

/// What the store says of the forecast that a morning rests on, and of how those before it did.
[[nodiscard]] KnownForecast known_of(const Morning& morning, const Site& site,
                                     const std::filesystem::path& store_folder);

/// A morning made from beginning to end, and where it lies.
struct MadeMorning {
  Morning morning;
  KnownForecast known;
  std::filesystem::path html;
};

/// How a morning is made.
struct MakeMorning {
  MorningQuestion question;
  std::optional<FlyWindows> fly;
  std::filesystem::path html;          ///< empty: STORE/reports/SITE/DAY.html
  std::string page_mark;               ///< behind the day in that name
  std::string generated;               ///< when and by what
  std::optional<KnownForecast> known;  ///< absent: looked up in the store
  /// Called when the first page stands, before anything is flown.
  std::function<void(const MadeMorning&)> on_first_page;
  std::function<void(double share)> on_progress;  ///< of the flights
};

/// Works out the windows and the plan, writes the page, then flies what is left open, plans anew
/// and writes the page again. Flights that fail are told; the first page stands.
/// @throws as `morning_of`; Error(unavailable) where the page cannot be written
[[nodiscard]] MadeMorning make_morning(const MakeMorning& how, const Site& site,
                                       const std::filesystem::path& store_folder);

/// The page of a forecast with how the ones before it did.
[[nodiscard]] ForecastPage page_of(std::shared_ptr<const Snapshot> forecast, const Site& site,
                                   const KnownForecast& known, const std::string& generated);

/// STORE/reports/SITE.
[[nodiscard]] std::filesystem::path reports_folder(const std::filesystem::path& store_folder,
                                                   const std::string& site_id);

}  // namespace slackwater::api
