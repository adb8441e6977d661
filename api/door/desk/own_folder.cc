#include "api/door/desk/own_folder.h"

#include <cstdlib>
#include <string>

#include "fields/base/error.h"

namespace slackwater::api::desk {

OwnFolder::OwnFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "slackwater-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr)
    throw Error(ErrorKind::unavailable,
                "no folder for temporary files could be made; check the space of the server");
  path_ = name;
}

OwnFolder::~OwnFolder() {
  std::error_code kept;
  std::filesystem::remove_all(path_, kept);
}

}  // namespace slackwater::api::desk
