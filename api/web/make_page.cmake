# Script: leaves ${ASSETS}/page.js, page.css and data, empty where npm, the registry or flatc is out
# of reach.
#
#   cmake -DNPM=npm -DFROM=api/web/desk -DLOOK=api/web/look -DASSETS=build/desk-page -DADDRESS=/
#         [-DFLATC=flatc -DSCHEMA=session.fbs] [-DDATA=package/file] -P api/web/make_page.cmake
get_filename_component(FROM ${FROM} ABSOLUTE)
get_filename_component(LOOK ${LOOK} ABSOLUTE)
get_filename_component(ASSETS ${ASSETS} ABSOLUTE)

function(give_up reason)
  message(WARNING "The page ${ADDRESS} is built without its script: ${reason}. With npm, flatc and "
                  "a network, touch ${FROM}/package.json and build again.")
  foreach(made page.js page.css data)
    file(WRITE ${ASSETS}/${made} "")
  endforeach()
endfunction()

file(MAKE_DIRECTORY ${ASSETS})
if(NOT NPM)
  give_up("npm was not found")
  return()
endif()
if(SCHEMA AND NOT FLATC)
  give_up("flatc was not found")
  return()
endif()

# npm ci throws node_modules away each time; only a changed lock file asks for that.
file(COPY ${FROM}/package.json ${FROM}/package-lock.json DESTINATION ${ASSETS})
file(SHA256 ${FROM}/package-lock.json wanted)
set(installed "")
if(EXISTS ${ASSETS}/node_modules/.slackwater-lock)
  file(READ ${ASSETS}/node_modules/.slackwater-lock installed)
endif()
if(NOT installed STREQUAL wanted)
  execute_process(
    COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --loglevel=error
    WORKING_DIRECTORY ${ASSETS} RESULT_VARIABLE result ERROR_VARIABLE reason
    OUTPUT_QUIET TIMEOUT 240)
  if(NOT result EQUAL 0)
    if(reason STREQUAL "")
      set(reason "npm ci failed (${result})")
    endif()
    give_up("${reason}")
    return()
  endif()
  file(WRITE ${ASSETS}/node_modules/.slackwater-lock ${wanted})
endif()

# The sources beside their packages, as tsc and esbuild look for them; frames from the schema.
file(REMOVE_RECURSE ${ASSETS}/page ${ASSETS}/look)
set(sources FILES_MATCHING PATTERN "*.ts" PATTERN "*.css" PATTERN "tsconfig.json"
    PATTERN "lessons/*/*.json")
file(COPY ${FROM}/ DESTINATION ${ASSETS}/page ${sources})
file(COPY ${LOOK}/ DESTINATION ${ASSETS}/look ${sources})
if(SCHEMA)
  execute_process(
    COMMAND ${FLATC} --ts -o ${ASSETS}/page/generated ${SCHEMA}
    RESULT_VARIABLE result ERROR_VARIABLE reason OUTPUT_VARIABLE said)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "flatc does not take ${SCHEMA}:\n${said}${reason}")
  endif()
endif()

set(tools ${ASSETS}/node_modules/.bin)
execute_process(COMMAND ${tools}/tsc --noEmit -p ${ASSETS}/page WORKING_DIRECTORY ${ASSETS}
                RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE reason)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "The script of the page ${ADDRESS} has errors:\n${said}${reason}")
endif()
execute_process(
  COMMAND ${tools}/esbuild page=page/main.ts page=page/page.css --bundle --format=iife
          --target=es2022 --minify --charset=utf8 --legal-comments=eof --log-level=warning
          --outdir=.
  WORKING_DIRECTORY ${ASSETS} RESULT_VARIABLE result ERROR_VARIABLE reason)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "esbuild does not bundle the page ${ADDRESS}:\n${reason}")
endif()
file(WRITE ${ASSETS}/data "")
if(DATA)
  configure_file(${ASSETS}/node_modules/${DATA} ${ASSETS}/data COPYONLY)
endif()
