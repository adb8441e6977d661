# What `cmake --install` puts where, in two components.
#   runtime:      bin/slackwater, share/slackwater (what data_folder() finds beside the program),
#                 units, pages
#   development:  headers of the rooms below include/slackwater with their paths, static
#                 libraries, find_package(Slackwater)
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS slackwater RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime)

# Every folder of data but those of code: products, sites, and what comes after them.
file(GLOB data_folders CONFIGURE_DEPENDS LIST_DIRECTORIES true ${PROJECT_SOURCE_DIR}/data/*)
foreach(folder ${data_folders})
  get_filename_component(name ${folder} NAME)
  if(IS_DIRECTORY ${folder} AND NOT name MATCHES "^(store|schema|bag)$")
    install(DIRECTORY ${folder} DESTINATION ${CMAKE_INSTALL_DATADIR}/slackwater COMPONENT runtime)
  endif()
endforeach()
# The detector of hands, where the build could fetch it: hand_detector_files of
# api/door/people/hands_routes.h.
foreach(file hands.js hands.binarypb hands_solution_packed_assets.data
        hands_solution_packed_assets_loader.js hands_solution_simd_wasm_bin.js
        hands_solution_simd_wasm_bin.wasm hand_landmark_lite.tflite)
  install(FILES ${PROJECT_BINARY_DIR}/hands-page/node_modules/@mediapipe/hands/${file}
          DESTINATION ${CMAKE_INSTALL_DATADIR}/slackwater/hands COMPONENT runtime OPTIONAL)
endforeach()
# The types on DDS, for whoever builds clients.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/api/door/dds/idl
        DESTINATION ${CMAKE_INSTALL_DATADIR}/slackwater COMPONENT runtime)
file(GLOB pages CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/api/docs/*.md)
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${pages}
        DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/api/docs/nginx DESTINATION ${CMAKE_INSTALL_DOCDIR}
        COMPONENT runtime)
# What the program is made of, where cmake/sbom has told it of this build.
install(FILES ${PROJECT_BINARY_DIR}/sbom.cdx.json ${PROJECT_BINARY_DIR}/licences_of_parts.txt
        DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime OPTIONAL)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/debian/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR}
        COMPONENT runtime)

# The units name the program by its place, which is known when it is installed.
install(CODE "
  set(SLACKWATER_BIN \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_BINDIR}\")
  set(SLACKWATER_DOC \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATAROOTDIR}/doc/slackwater\")
  foreach(unit slackwater-daily@.service slackwater-daily@.timer slackwater-serve.service)
    configure_file(\"${PROJECT_SOURCE_DIR}/api/door/systemd/\${unit}.in\"
                   \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/lib/systemd/system/\${unit}\" @ONLY)
  endforeach()" COMPONENT runtime)
install(FILES ${PROJECT_SOURCE_DIR}/api/door/systemd/slackwater.conf DESTINATION lib/tmpfiles.d
        COMPONENT runtime)

# --- for programs of others ---------------------------------------------------------------------
set(rooms fields ingest calibration twin store)
foreach(room ${rooms})
  set_target_properties(slackwater_${room} PROPERTIES EXPORT_NAME ${room})
  list(APPEND exported slackwater_${room})
endforeach()
get_property(libraries GLOBAL PROPERTY SLACKWATER_LIBRARIES)
install(TARGETS ${exported} slackwater_options ${libraries} EXPORT SlackwaterTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
foreach(folder fields ingest calibration twin data/store)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}/
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/slackwater/${folder}
          COMPONENT development FILES_MATCHING PATTERN "*.h")
endforeach()

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Slackwater)
set(SLACKWATER_DATA_FOLDER ${CMAKE_INSTALL_DATADIR}/slackwater)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/SlackwaterConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/SlackwaterConfig.cmake
                              INSTALL_DESTINATION ${package_folder}
                              PATH_VARS SLACKWATER_DATA_FOLDER)
# Nothing of 0.x promises to fit anything but itself.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/SlackwaterConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/SlackwaterConfig.cmake
        ${PROJECT_BINARY_DIR}/SlackwaterConfigVersion.cmake
        DESTINATION ${package_folder} COMPONENT development)
install(EXPORT SlackwaterTargets NAMESPACE Slackwater:: DESTINATION ${package_folder}
        COMPONENT development)

# --- the Debian package: the runtime alone ------------------------------------------------------
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME slackwater)
set(CPACK_PACKAGE_VENDOR "Slackwater")
set(CPACK_PACKAGE_CONTACT "The Slackwater authors <slackwater@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR};slackwater;runtime;/")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "proj-data, tzdata")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "gpsd-clients")  # gpsdecode, for AIS alone
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "chromium")  # prints the morning report as a PDF
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
    "Reads each day's Copernicus Marine and weather products, calibrates an
Ekman-layer model of the current profile at a site, forecasts three days and
scores every forecast as issued. With systemd units for the daily job of a site
and for the HTTP service.")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/debian/postinst
    ${PROJECT_SOURCE_DIR}/cmake/debian/prerm ${PROJECT_SOURCE_DIR}/cmake/debian/postrm)
include(CPack)
