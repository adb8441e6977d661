# slackwater_page_look(<target>) gives page_look.cc of <target> the file that it carries.
set(SLACKWATER_LOOK_FOLDER ${CMAKE_CURRENT_LIST_DIR})

function(slackwater_page_look target)
  set(look ${CMAKE_BINARY_DIR}/page-look.css)
  set(script ${SLACKWATER_LOOK_FOLDER}/make_page_look.cmake)
  add_custom_command(
    OUTPUT ${look}
    COMMAND ${CMAKE_COMMAND} -DLOOK=${SLACKWATER_LOOK_FOLDER} -DOUT=${look} -P ${script}
    DEPENDS ${SLACKWATER_LOOK_FOLDER}/palette.css ${SLACKWATER_LOOK_FOLDER}/parts.css ${script}
    COMMENT "Making the look of pages that are one file"
    VERBATIM)
  set_source_files_properties(
    ${SLACKWATER_LOOK_FOLDER}/page_look.cc
    PROPERTIES COMPILE_DEFINITIONS "SLACKWATER_PAGE_LOOK=\"${look}\"" OBJECT_DEPENDS ${look}
               SKIP_UNITY_BUILD_INCLUSION ON)
  target_sources(${target} PRIVATE ${look})
endfunction()
