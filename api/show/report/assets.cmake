# What the report page carries inside itself: its style, its scripts and Apache ECharts.
#
# slackwater_report_assets(<target>) adds to <target> a generated source that holds them
# (api/show/report/assets.h). ECharts is fetched by `npm ci` at build time into
# ${CMAKE_BINARY_DIR}/report-assets, pinned and checked by package-lock.json. A build without npm or
# without a network succeeds all the same: the page then has tables and a sentence instead of plots,
# and the build says so.
set(SLACKWATER_REPORT_FOLDER ${CMAKE_CURRENT_LIST_DIR})

function(slackwater_report_assets target)
  set(assets ${CMAKE_BINARY_DIR}/report-assets)
  set(library ${assets}/echarts.min.js)
  find_program(NPM npm)
  if(NOT NPM)
    set(NPM "NPM-NOTFOUND")
  endif()
  add_custom_command(
    OUTPUT ${library}
    COMMAND ${CMAKE_COMMAND} -DNPM=${NPM} -DFROM=${SLACKWATER_REPORT_FOLDER} -DASSETS=${assets}
            -P ${SLACKWATER_REPORT_FOLDER}/fetch_echarts.cmake
    DEPENDS ${SLACKWATER_REPORT_FOLDER}/package.json ${SLACKWATER_REPORT_FOLDER}/package-lock.json
            ${SLACKWATER_REPORT_FOLDER}/fetch_echarts.cmake
    COMMENT "Fetching Apache ECharts for the report page"
    VERBATIM)

  set(SLACKWATER_REPORT_STYLE ${SLACKWATER_REPORT_FOLDER}/page/report.css)
  set(SLACKWATER_REPORT_COMMON_SCRIPT ${SLACKWATER_REPORT_FOLDER}/page/common.js)
  set(SLACKWATER_REPORT_SCRIPT ${SLACKWATER_REPORT_FOLDER}/page/report.js)
  set(SLACKWATER_SKILL_SCRIPT ${SLACKWATER_REPORT_FOLDER}/page/skill.js)
  set(SLACKWATER_RUN_SCRIPT ${SLACKWATER_REPORT_FOLDER}/page/run.js)
  set(SLACKWATER_REHEARSAL_SCRIPT ${SLACKWATER_REPORT_FOLDER}/page/rehearsal.js)
  set(SLACKWATER_VEHICLE_SCRIPT ${SLACKWATER_REPORT_FOLDER}/page/vehicle.js)
  set(SLACKWATER_REPORT_LIBRARY ${library})
  configure_file(${SLACKWATER_REPORT_FOLDER}/assets.cc.in ${assets}/assets.cc @ONLY)
  set(parts ${SLACKWATER_REPORT_STYLE} ${SLACKWATER_REPORT_COMMON_SCRIPT}
      ${SLACKWATER_REPORT_SCRIPT} ${SLACKWATER_SKILL_SCRIPT} ${SLACKWATER_RUN_SCRIPT}
      ${SLACKWATER_REHEARSAL_SCRIPT} ${SLACKWATER_VEHICLE_SCRIPT} ${library})
  set_source_files_properties(${assets}/assets.cc PROPERTIES OBJECT_DEPENDS "${parts}")
  target_sources(${target} PRIVATE ${assets}/assets.cc)
endfunction()
