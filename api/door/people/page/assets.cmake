# The page `/session`, carried inside the program.
#
# slackwater_session_page(<target>) adds to <target> a generated source that holds its html, script
# and style (api/door/people/page/assets.h). The script is made at build time in
# ${CMAKE_BINARY_DIR}/session-page: npm ci by package-lock.json, flatc for the frames, tsc, esbuild.
# A build without npm, flatc or a network succeeds all the same: the script is then empty, the page
# says so, and the build warns. An error in our own TypeScript stops the build.
set(SLACKWATER_SESSION_PAGE_FOLDER ${CMAKE_CURRENT_LIST_DIR})

function(slackwater_session_page target)
  set(from ${SLACKWATER_SESSION_PAGE_FOLDER})
  set(schema ${from}/../wire/session.fbs)
  set(assets ${CMAKE_BINARY_DIR}/session-page)
  set(script ${assets}/page.js)
  find_program(NPM npm)
  if(NOT NPM)
    set(NPM "NPM-NOTFOUND")
  endif()
  find_program(FLATC flatc)
  if(NOT FLATC)
    set(FLATC "FLATC-NOTFOUND")
  endif()
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${from}/*.ts)
  add_custom_command(
    OUTPUT ${script}
    COMMAND ${CMAKE_COMMAND} -DNPM=${NPM} -DFLATC=${FLATC} -DFROM=${from} -DSCHEMA=${schema}
            -DASSETS=${assets} -P ${from}/make_page.cmake
    DEPENDS ${sources} ${schema} ${from}/package.json ${from}/package-lock.json
            ${from}/tsconfig.json
            ${from}/make_page.cmake
    COMMENT "Making the script of the page /session"
    VERBATIM)

  set(SLACKWATER_SESSION_PAGE_HTML ${from}/page.html)
  set(SLACKWATER_SESSION_PAGE_STYLE ${from}/page.css)
  set(SLACKWATER_SESSION_PAGE_SCRIPT ${script})
  configure_file(${from}/assets.cc.in ${assets}/assets.cc @ONLY)
  set_source_files_properties(
    ${assets}/assets.cc PROPERTIES OBJECT_DEPENDS "${from}/page.html;${from}/page.css;${script}")
  target_sources(${target} PRIVATE ${assets}/assets.cc)
endfunction()
