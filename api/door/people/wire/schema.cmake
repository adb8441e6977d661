# What flatc makes of session.fbs: the frames as C++ reads and writes them. The page has its own of
# the same file (page/assets.cmake).
find_program(FLATC flatc REQUIRED)

function(slackwater_session_schema target)
  set(folder ${PROJECT_BINARY_DIR}/session-frames)
  set(made ${folder}/session)
  set(schema ${PROJECT_SOURCE_DIR}/api/door/people/wire/session.fbs)
  add_custom_command(
    OUTPUT ${made}/session_generated.h
    COMMAND ${FLATC} --cpp --scoped-enums -o ${made} ${schema}
    DEPENDS ${schema}
    COMMENT "Making the frames of a session"
    VERBATIM)
  target_sources(${target} PRIVATE ${made}/session_generated.h)
  target_include_directories(${target} SYSTEM PUBLIC ${folder})
  # For clang-tidy, which reads without building.
  add_custom_target(slackwater_session_frames DEPENDS ${made}/session_generated.h)
endfunction()
