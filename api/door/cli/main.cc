#include "api/door/cli/command.h"

int main(int argc, char** argv) { return slackwater::api::run_command_line(argc, argv); }
