#include "api/door/cli/command.h"
#include "api/door/cli/plain_output.h"

int main(int argc, char** argv) {
  slackwater::api::print_plain_text();
  return slackwater::api::run_command_line(argc, argv);
}
