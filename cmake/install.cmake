# cmake --install: the command, the libraries with their headers, data and scenes, and a package that
# find_package(overstrike) finds.
include(CMakePackageConfigHelpers)

set(OVERSTRIKE_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/overstrike)

install(TARGETS overstrike RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS overstrike_core overstrike_readers overstrike_devices overstrike_emulators
  EXPORT overstrike ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT overstrike NAMESPACE overstrike:: FILE overstrikeTargets.cmake
  DESTINATION ${OVERSTRIKE_PACKAGE_DIR})

foreach(room core scenes/readers devices emulators)
  install(DIRECTORY ${room}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/overstrike/${room}
    FILES_MATCHING PATTERN "*.h")
endforeach()
install(DIRECTORY scenes/ DESTINATION ${CMAKE_INSTALL_DATADIR}/overstrike/scenes
  PATTERN readers EXCLUDE)

configure_package_config_file(cmake/overstrikeConfig.cmake.in
  ${PROJECT_BINARY_DIR}/overstrikeConfig.cmake INSTALL_DESTINATION ${OVERSTRIKE_PACKAGE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/overstrikeConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/overstrikeConfig.cmake
  ${PROJECT_BINARY_DIR}/overstrikeConfigVersion.cmake DESTINATION ${OVERSTRIKE_PACKAGE_DIR})
