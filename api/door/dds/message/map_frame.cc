#include "api/door/dds/message/map_frame.h"

#include "fields/base/error.h"
#include "twin/run/printable.h"

namespace slackwater::dds {

void expect_map(const char* what, const std::string& frame_id) {
  if (frame_id.empty() || frame_id == map_frame) return;
  throw Error(ErrorKind::invalid_input, std::string(what) + " is in the frame '" +
                                            twin::printable(frame_id, 80) +
                                            "'; give it in `map`: east, north, up of the origin");
}

}  // namespace slackwater::dds
