# SPDX-License-Identifier: GPL-3.0-or-later
# cmake --install: libraries, headers, Fortran module file, licence, CMake package and pkg-config files. All paths inside are
# relative to where the files lie, so that the installed folder can be moved.
include(CMakePackageConfigHelpers)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/mdrcontact")

foreach(kind IN ITEMS static shared)
  install(TARGETS mdrcontact_${kind} EXPORT mdrcontact_${kind}
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
  install(EXPORT mdrcontact_${kind} NAMESPACE mdrcontact:: DESTINATION "${package_dir}")
endforeach()
install(DIRECTORY "${mdrcontact_include_dir}/" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" FILES_MATCHING PATTERN "*.h*")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")
# gfortran's module file holds all that it re-exports; others read the modules behind it too, of which
# those of the C layer are internal.
if(CMAKE_Fortran_COMPILER_ID STREQUAL "GNU")
  set(pattern PATTERN "mdrcontact.mod")
else()
  set(pattern PATTERN "*.mod" PATTERN "mdrcontact_api_*" EXCLUDE)
endif()
install(DIRECTORY "${CMAKE_BINARY_DIR}/modules/" DESTINATION "${mdrcontact_module_dir}" FILES_MATCHING ${pattern})

if(CMAKE_BUILD_TYPE)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" mdrcontact_config)
else()
  set(mdrcontact_config NOCONFIG)
endif()
configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/mdrcontact-config.cmake.in"
  "${PROJECT_BINARY_DIR}/mdrcontact-config.cmake" INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/mdrcontact-config-version.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/mdrcontact-config.cmake" "${PROJECT_BINARY_DIR}/mdrcontact-config-version.cmake"
  DESTINATION "${package_dir}")

# pkg-config: mdrcontact is the shared library for C, with --static the static one; mdrcontact-static the static one where both are
# installed, for C and Fortran. What it needs stands there as -l names without this machine's paths.
file(RELATIVE_PATH prefix_from_pc "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
string(REGEX REPLACE "/$" "" prefix_from_pc "${prefix_from_pc}")
set(private_libraries "")
foreach(library IN LISTS GSL_LIBRARIES LAPACK_LIBRARIES mdrcontact_runtime_libraries ITEMS m)
  get_filename_component(name "${library}" NAME_WE)
  string(REGEX REPLACE "^(-l|lib)" "" name "${name}")
  string(APPEND private_libraries " -l${name}")
endforeach()
set(package_name mdrcontact)
set(package_libs "-L\${libdir} -lmdrcontact")
configure_file("${PROJECT_SOURCE_DIR}/cmake/mdrcontact.pc.in" "${PROJECT_BINARY_DIR}/mdrcontact.pc" @ONLY)
set(package_name mdrcontact-static)
set(package_words " (static, with the Fortran modules)")
set(package_cflags " -I\${prefix}/${mdrcontact_module_dir}")
set(package_libs "\${libdir}/${CMAKE_STATIC_LIBRARY_PREFIX}mdrcontact${CMAKE_STATIC_LIBRARY_SUFFIX}${private_libraries}")
set(private_libraries "")
configure_file("${PROJECT_SOURCE_DIR}/cmake/mdrcontact.pc.in" "${PROJECT_BINARY_DIR}/mdrcontact-static.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/mdrcontact.pc" "${PROJECT_BINARY_DIR}/mdrcontact-static.pc"
  DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")

if(is_top_level)
  add_custom_target(uninstall COMMAND ${CMAKE_COMMAND} "-Dmanifest=${CMAKE_BINARY_DIR}/install_manifest.txt"
    -P "${PROJECT_SOURCE_DIR}/cmake/mdrcontact_uninstall.cmake" VERBATIM)
endif()
