#include "api/program/version.h"

namespace slackwater::api {

std::string code_version() {
#ifdef SLACKWATER_COMMIT
  return std::string(SLACKWATER_VERSION "+") + SLACKWATER_COMMIT;
#else
  return SLACKWATER_VERSION;
#endif
}

}  // namespace slackwater::api
