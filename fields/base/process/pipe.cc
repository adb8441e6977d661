#include "fields/base/process/pipe.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "fields/base/error.h"

namespace slackwater {

Pipe::Pipe() {
  if (::pipe2(ends_.data(), O_CLOEXEC) != 0)
    throw Error(ErrorKind::unavailable,
                std::string("cannot make a pipe: ") + std::strerror(errno) + "; try again");
}

Pipe::~Pipe() {
  close(0);
  close(1);
}

void Pipe::close(std::size_t end) noexcept {
  if (ends_.at(end) >= 0) ::close(ends_.at(end));
  ends_.at(end) = -1;
}

}  // namespace slackwater
