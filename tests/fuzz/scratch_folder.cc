#include "tests/fuzz/scratch_folder.h"

#include <stdlib.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "tests/fuzz/fuzz_case.h"

namespace slackwater::fuzz {

ScratchFolder::ScratchFolder() {
  const std::filesystem::path memory = "/dev/shm";
  const bool in_memory = ::access(memory.c_str(), W_OK) == 0;
  std::string form =
      (in_memory ? memory : std::filesystem::temp_directory_path()) / "slackwater-fuzz-XXXXXX";
  if (::mkdtemp(form.data()) == nullptr) fail("cannot make " + form);
  path_ = form;
  std::filesystem::create_directory(staging());
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path ScratchFolder::file_of(const std::uint8_t* data, std::size_t size,
                                             const char* name) {
  for (const auto& staged : std::filesystem::directory_iterator(staging()))
    std::filesystem::remove_all(staged);
  std::filesystem::path file = path_ / name;
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  stream.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  stream.close();
  if (!stream) fail("cannot write " + file.string());
  return file;
}

ScratchFolder& scratch_folder() {
  static ScratchFolder folder;
  return folder;
}

}  // namespace slackwater::fuzz
