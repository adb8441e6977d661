# The page `/`, the desk, carried inside the program.
#
# slackwater_desk_page(<target>) adds to <target> a generated source that holds its html, script,
# style and coast (api/door/desk/page/assets.h). Script and style are made at build time in
# ${CMAKE_BINARY_DIR}/desk-page: npm ci by package-lock.json, tsc, esbuild; the coast is Natural
# Earth's, of the npm package world-atlas. A build without npm or a network succeeds all the same:
# all three are then empty, the page says so, and the build warns. An error in our own
# TypeScript stops the build.
set(SLACKWATER_DESK_PAGE_FOLDER ${CMAKE_CURRENT_LIST_DIR})

function(slackwater_desk_page target)
  set(from ${SLACKWATER_DESK_PAGE_FOLDER})
  set(assets ${CMAKE_BINARY_DIR}/desk-page)
  set(script ${assets}/page.js)
  set(style ${assets}/page.css)
  set(land ${assets}/land-50m.json)
  find_program(NPM npm)
  if(NOT NPM)
    set(NPM "NPM-NOTFOUND")
  endif()
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${from}/*.ts ${from}/*.css)
  add_custom_command(
    OUTPUT ${script} ${style} ${land}
    COMMAND ${CMAKE_COMMAND} -DNPM=${NPM} -DFROM=${from} -DASSETS=${assets}
            -P ${from}/make_page.cmake
    DEPENDS ${sources} ${from}/package.json ${from}/package-lock.json ${from}/tsconfig.json
            ${from}/make_page.cmake
    COMMENT "Making the script of the page /"
    VERBATIM)

  set(SLACKWATER_DESK_PAGE_HTML ${from}/page.html)
  set(SLACKWATER_DESK_PAGE_STYLE ${style})
  set(SLACKWATER_DESK_PAGE_SCRIPT ${script})
  set(SLACKWATER_DESK_PAGE_LAND ${land})
  configure_file(${from}/assets.cc.in ${assets}/assets.cc @ONLY)
  set_source_files_properties(
    ${assets}/assets.cc PROPERTIES OBJECT_DEPENDS
                                   "${from}/page.html;${style};${script};${land}")
  target_sources(${target} PRIVATE ${assets}/assets.cc)
endfunction()
