#include "api/pipeline/past_skill.h"

#include "api/pipeline/verify.h"
#include "fields/base/attempt.h"

namespace slackwater::api {

PastSkill verify_past(store::Store& store, const Site& site, const SiteData& data,
                      const Snapshot& snapshot, WindPolicy wind) {
  calibration::VerifyOptions options;
  options.from = snapshot.day - std::chrono::days(14);
  options.issued_before = snapshot.issued;
  options.only = ForecastOrigin::forecast;
  options.truth_until = snapshot.issued;
  options.leads = {{0, 24}};
  options.bands = {{0, calibration::whole_column_m}};
  options.by_hour = false;
  PastSkill past;
  past.wind = wind;
  const auto failure = attempt([&] {
    calibration::Verification verification = verify_with(store, site, data, options);
    past.unscored = std::move(verification.unscored);
    past.entries = std::move(verification.entries);
    past.verdict = calibration::verdict_of(past.entries, wind);
  });
  if (failure) past.not_verified = "Not verified, the verification failed: " + failure->why;
  return past;
}

}  // namespace slackwater::api
