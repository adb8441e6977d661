// made_up_messages FOLDER: writes every structure of api/door/dds/idl, filled with counted values,
// as api/door/dds has it on the wire: FOLDER/package.kind.Name.FIRST.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "api/door/dds/message/cdr.h"
#include "every_type.h"
#include "tests/strangers/dds/counted_values.h"

namespace slackwater::tests {
namespace {

template <typename Message>
void write(const std::filesystem::path& folder, const std::string& name) {
  for (unsigned first = 0; first < 8; ++first) {
    Message message;
    CountedValues(first).put(message);
    const dds::Bytes bytes = dds::encoded(message);
    if (dds::encoded(dds::decoded<Message>(bytes)) != bytes)
      throw Error(ErrorKind::internal, name + " is not what it was when it is read");
    std::ofstream file(folder / (name + "." + std::to_string(first)), std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  }
}

}  // namespace
}  // namespace slackwater::tests

#define WRITE(package, kind, name) \
  slackwater::tests::write<package::kind::name>(argv[1], #package "." #kind "." #name);

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "made_up_messages FOLDER\n");
    return 2;
  }
  SLACKWATER_EVERY_TYPE(WRITE)
  return 0;
}
