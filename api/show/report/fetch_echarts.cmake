# Script: leaves ${ASSETS}/echarts.min.js, empty where npm or the registry is out of reach.
file(MAKE_DIRECTORY ${ASSETS})
file(COPY ${FROM}/package.json ${FROM}/package-lock.json DESTINATION ${ASSETS})
set(library ${ASSETS}/node_modules/echarts/dist/echarts.min.js)
set(reason "npm was not found")
if(NPM)
  execute_process(
    COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --loglevel=error
    WORKING_DIRECTORY ${ASSETS} RESULT_VARIABLE result ERROR_VARIABLE reason
    OUTPUT_QUIET TIMEOUT 180)
endif()
if(NPM AND result EQUAL 0 AND EXISTS ${library})
  configure_file(${library} ${ASSETS}/echarts.min.js COPYONLY)
  file(TOUCH ${ASSETS}/echarts.min.js)
else()
  if(NPM AND reason STREQUAL "")
    set(reason "npm ci failed (${result})")
  endif()
  message(WARNING "The report page is built without plots: ${reason}. "
                  "With npm and a network, touch api/show/report/package.json and build again.")
  file(WRITE ${ASSETS}/echarts.min.js "")
endif()
