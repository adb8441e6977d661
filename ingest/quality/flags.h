#pragma once
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fields/grid/status.h"

namespace slackwater::ingest {

/// What the numbers of a quality flag mean. "Nobody has looked" is `not_checked`, which is neither
/// good nor bad:
///
///   flag  OceanSITES, Copernicus in situ, IMOS, Argo   SeaDataNet L20             status
///   0     no QC performed                              no quality control         not_checked
///   1, 2  good, probably good                          good, probably good        ok
///   3, 4  correctable bad, bad                         probably bad, bad          suspect
///   5     value changed                                value changed              ok
///   6     not used                                     below detection            not_checked / ok
///   7     nominal (position of a mooring)              in excess                  ok / suspect
///   8     interpolated                                 interpolated               ok
///   9     missing value                                missing value              missing
///
/// Sources: OceanSITES Data Format Reference Manual 1.4, reference table 2; Copernicus Marine In
/// Situ TAC reference table 2; IMOS NetCDF Conventions 1.4, table 6.4; SeaDataNet vocabulary L20.
class FlagScheme {
 public:
  /// From the CF attributes `flag_values` and `flag_meanings` (words apart by blanks, commas or
  /// line ends), which win; else from a `conventions` text that names one of the tables above (or
  /// QARTOD). Nothing where neither says what the numbers mean. Unknown words read as not_checked.
  [[nodiscard]] static std::optional<FlagScheme> from_attributes(
      std::span<const double> flag_values, std::string_view flag_meanings,
      std::string_view conventions);
  /// A number that the scheme does not list (the flag's own fill value among them) is not_checked.
  [[nodiscard]] SampleStatus status_of(long flag) const noexcept;

 private:
  std::map<long, SampleStatus> status_of_flag_;
};

/// The status that a meaning's words say, e.g. "bad_data_that_are_potentially_correctable" ->
/// suspect.
[[nodiscard]] SampleStatus status_of_meaning(std::string_view meaning) noexcept;

}  // namespace slackwater::ingest
