// made_up_store FOLDER: a store with the made-up forecasts of tests/api/edr, for `slackwater
// serve`.
#include "tests/api/door/edr/made_up_store.h"

#include <cstdio>
#include <exception>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "give FOLDER\n");
    return 2;
  }
  try {
    slackwater::tests::fill_with_made_up_forecasts(argv[1]);
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s\n", problem.what());
    return 1;
  }
  return 0;
}
