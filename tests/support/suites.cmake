# Read by ctest: one test for each suite of a test program, of the suite's name. A suite is one
# process, since most tests take less time than a program under the sanitizers takes to start.
#
# Those of `soak_suites` take a minute or more and prove what seldom changes: `make soak` runs them,
# `make test` does not.
set(soak_suites AdcpNorthSea AdcpWashington FusionTwin JumpingClock PublishedProfiles RealPairs)
# slackwater_suites(<program> <label>)
function(slackwater_suites program label)
  if(NOT EXISTS ${program})
    add_test(${label}_NOT_BUILT ${program})
    return()
  endif()
  set(listed ${program}_suites.txt)
  if(NOT EXISTS ${listed} OR ${program} IS_NEWER_THAN ${listed})
    execute_process(COMMAND ${program} --gtest_list_tests OUTPUT_VARIABLE tests
                    RESULT_VARIABLE result)
    if(result)
      message(FATAL_ERROR "${program} --gtest_list_tests: ${result}")
    endif()
    string(REGEX MATCHALL "(^|\n)[^ \n]+\\." suites "${tests}")
    string(REGEX REPLACE "[.\n]" "" suites "${suites}")
    file(WRITE ${listed} "${suites}")
  endif()
  file(READ ${listed} suites)
  cmake_path(GET program PARENT_PATH folder)
  foreach(suite ${suites})
    add_test(${suite} ${program} --gtest_filter=${suite}.* --gtest_color=no)
    set(labels ${label})
    list(FIND soak_suites ${suite} at)  # ctest reads this without the policy of IN_LIST
    if(NOT at EQUAL -1)
      list(APPEND labels soak)
    endif()
    # Skipped is a suite whose every test was. Half an hour: long runs have many days in one suite.
    set_tests_properties(${suite} PROPERTIES LABELS "${labels}" TIMEOUT 1800
      WORKING_DIRECTORY ${folder}
      SKIP_REGULAR_EXPRESSION "  PASSED  . 0 tests.\n(.  SKIPPED . [^\n]*\n)+$")
  endforeach()
endfunction()
