#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "fields/base/time.h"

namespace slackwater::ingest {

/// A program of others that reads its standard input and answers on its standard output.
struct FilterProgram {
  std::vector<std::string> command;  ///< found on the PATH and run as it stands: no shell reads it
  std::string install_advice;        ///< "apt install gpsd-clients"
  Duration patience = std::chrono::seconds(30);  ///< without a byte in either direction
  /// It needs its input alone, and gets no more: no file but those of its libraries, no network, no
  /// other program (fields/base/process/confinement.h).
  bool is_confined = false;
};

/// Appends input for the program. @return false when there is no more
using Produce = std::function<bool(std::string& input)>;
/// Takes one line of its output, without the line's end.
using Consume = std::function<void(std::string_view line)>;

/// Runs the program to its end in constant memory: it is fed and read in turn, as it has room and
/// answers. The program sees our environment with LC_ALL=C; its standard error is dropped. When an
/// exception leaves this function the program is killed and waited for.
///
/// @throws Error(unavailable) where the program is not installed, cannot start, does not answer,
/// stops reading, is
///         killed or fails; whatever `produce` and `consume` throw
void run_filter(const FilterProgram& program, const Produce& produce, const Consume& consume);

}  // namespace slackwater::ingest
