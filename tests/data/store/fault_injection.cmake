# Included at the end of the configuration, when slackwater_data_tests exists (see
# data/CMakeLists.txt): the interposed libc, the program that runs under it, and their paths for the
# tests.
if(TARGET slackwater_data_tests)
  set(here ${PROJECT_SOURCE_DIR}/tests/data/store)
  target_sources(slackwater_data_tests PRIVATE ${here}/disk_model.cc ${here}/worker_process.cc)

  # Not sanitized and not optimised away: it stands between a program and libc.
  add_library(slackwater_fault_injection MODULE ${here}/fault_injection.cc)
  target_include_directories(slackwater_fault_injection PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(slackwater_fault_injection PRIVATE ${CMAKE_DL_LIBS})

  add_executable(slackwater_store_worker ${here}/store_worker.cc)
  target_link_libraries(slackwater_store_worker PRIVATE slackwater::store slackwater_test_support)

  add_dependencies(slackwater_data_tests slackwater_fault_injection slackwater_store_worker)
  target_compile_definitions(slackwater_data_tests PRIVATE
    SLACKWATER_STORE_WORKER="$<TARGET_FILE:slackwater_store_worker>"
    SLACKWATER_FAULT_INJECTION="$<TARGET_FILE:slackwater_fault_injection>")
endif()
