# Pages, carried inside the program.
#
# slackwater_page(<target> <page> ADDRESS <path> [SCHEMA <file.fbs>] [DATA <file of a package>])
# adds to <target> a generated source that holds what api/web/<page>/ makes (api/web/assets.h).
# Script and style are made at build time in ${CMAKE_BINARY_DIR}/<page>-page: npm ci by
# package-lock.json, flatc where there is a schema, tsc, esbuild. A build without npm, flatc or a
# network succeeds all the same: they are then empty, the page says so, and the build warns. An
# error in our own TypeScript stops the build.
set(SLACKWATER_WEB_FOLDER ${CMAKE_CURRENT_LIST_DIR})

function(slackwater_page target PAGE)
  cmake_parse_arguments(given "" "ADDRESS;SCHEMA;DATA" "" ${ARGN})
  set(from ${SLACKWATER_WEB_FOLDER}/${PAGE})
  set(look ${SLACKWATER_WEB_FOLDER}/look)
  set(assets ${CMAKE_BINARY_DIR}/${PAGE}-page)
  set(HTML ${from}/page.html)
  set(SCRIPT ${assets}/page.js)
  set(STYLE ${assets}/page.css)
  set(DATA ${assets}/data)
  find_program(NPM npm)
  if(NOT NPM)
    set(NPM "NPM-NOTFOUND")
  endif()
  find_program(FLATC flatc)
  if(NOT FLATC)
    set(FLATC "FLATC-NOTFOUND")
  endif()
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${from}/*.ts ${from}/*.css
       ${from}/lessons/*.json ${look}/*.ts ${look}/*.css)
  add_custom_command(
    OUTPUT ${SCRIPT} ${STYLE} ${DATA}
    COMMAND ${CMAKE_COMMAND} -DNPM=${NPM} -DFLATC=${FLATC} -DFROM=${from} -DLOOK=${look}
            -DASSETS=${assets} -DADDRESS=${given_ADDRESS} "-DSCHEMA=${given_SCHEMA}"
            "-DDATA=${given_DATA}" -P ${SLACKWATER_WEB_FOLDER}/make_page.cmake
    DEPENDS ${sources} ${given_SCHEMA} ${from}/package.json ${from}/package-lock.json
            ${from}/tsconfig.json ${SLACKWATER_WEB_FOLDER}/make_page.cmake
    COMMENT "Making the page ${given_ADDRESS}"
    VERBATIM)
  configure_file(${SLACKWATER_WEB_FOLDER}/assets.cc.in ${assets}/assets.cc @ONLY)
  set_source_files_properties(${assets}/assets.cc
                              PROPERTIES OBJECT_DEPENDS "${HTML};${SCRIPT};${STYLE};${DATA}")
  target_sources(${target} PRIVATE ${assets}/assets.cc)
endfunction()
