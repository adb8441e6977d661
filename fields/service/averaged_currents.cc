#include "fields/service/averaged_currents.h"

#include "fields/base/numbers/averaging.h"
#include "fields/base/text.h"

namespace slackwater {

std::string sentence_of(const AveragedCurrents& averaged) {
  const std::string what = "the currents are " + averaging_text(averaged.averaging) +
                           (averaged.holds_part_of_the_tide ? ": they hold only part of the tide"
                                                            : ": they do not hold the tide");
  if (!averaged.unresolved_tide_m_s) return what + ", and its size is not known";
  return what + formatted(", the band is widened by up to {:.2f} m/s for it (tide of {})",
                          *averaged.unresolved_tide_m_s, averaged.tidal_record);
}

}  // namespace slackwater
