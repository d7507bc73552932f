# SPDX-License-Identifier: GPL-3.0-or-later
# The C library in the wheel: headers, shared library, CMake package and pkg-config file, found by mdrcontact.get_include() and its
# like. One file of the library, named as programs look for it, since a wheel has no symbolic links.
set(package_dir mdrcontact)
set(library_name "$<TARGET_SONAME_FILE_NAME:mdrcontact_shared>")
install(PROGRAMS "$<TARGET_FILE:mdrcontact_shared>" DESTINATION "${package_dir}/lib" RENAME "${library_name}"
  COMPONENT python EXCLUDE_FROM_ALL)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/" DESTINATION "${package_dir}/include" COMPONENT python EXCLUDE_FROM_ALL
  FILES_MATCHING PATTERN "*.h*")

configure_file("${PROJECT_SOURCE_DIR}/cmake/wheel-config.cmake.in" "${CMAKE_CURRENT_BINARY_DIR}/wheel-config.cmake.in" @ONLY)
file(GENERATE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/wheel/mdrcontact-config.cmake"
  INPUT "${CMAKE_CURRENT_BINARY_DIR}/wheel-config.cmake.in")
include(CMakePackageConfigHelpers)
write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/wheel/mdrcontact-config-version.cmake"
  VERSION ${PROJECT_VERSION} COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/wheel/mdrcontact-config.cmake"
    "${CMAKE_CURRENT_BINARY_DIR}/wheel/mdrcontact-config-version.cmake"
  DESTINATION "${package_dir}/cmake" COMPONENT python EXCLUDE_FROM_ALL)

configure_file("${PROJECT_SOURCE_DIR}/cmake/wheel.pc.in" "${CMAKE_CURRENT_BINARY_DIR}/wheel.pc.in" @ONLY)
file(GENERATE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/wheel/mdrcontact.pc" INPUT "${CMAKE_CURRENT_BINARY_DIR}/wheel.pc.in")
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/wheel/mdrcontact.pc" DESTINATION "${package_dir}/pkgconfig" COMPONENT python
  EXCLUDE_FROM_ALL)
