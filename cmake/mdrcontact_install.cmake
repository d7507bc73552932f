# SPDX-License-Identifier: GPL-3.0-or-later
# cmake --install: libraries, header, Fortran module files, CMake package and pkg-config file. All paths inside are relative to where
# the files lie, so that the installed folder can be moved.
include(CMakePackageConfigHelpers)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/mdrcontact")

install(TARGETS mdrcontact_static mdrcontact_shared EXPORT mdrcontact_targets
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
install(FILES "${PROJECT_SOURCE_DIR}/include/mdrcontact.h" "${PROJECT_SOURCE_DIR}/include/mdrcontact_law.h" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
# Module files belong to one compiler; those of the C layer are nobody's business.
install(DIRECTORY "${CMAKE_BINARY_DIR}/modules/" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/mdrcontact/modules"
  FILES_MATCHING PATTERN "*.mod" PATTERN "mdrcontact_api_*" EXCLUDE)

install(EXPORT mdrcontact_targets NAMESPACE mdrcontact:: DESTINATION "${package_dir}")
configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/mdrcontact-config.cmake.in"
  "${CMAKE_BINARY_DIR}/mdrcontact-config.cmake" INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file("${CMAKE_BINARY_DIR}/mdrcontact-config-version.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_BINARY_DIR}/mdrcontact-config.cmake" "${CMAKE_BINARY_DIR}/mdrcontact-config-version.cmake"
  DESTINATION "${package_dir}")

# pkg-config: mdrcontact is the shared library for C; mdrcontact-static the static one, for C and Fortran, with what it needs as -l
# names without this machine's paths.
file(RELATIVE_PATH prefix_from_pc "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
string(REGEX REPLACE "/$" "" prefix_from_pc "${prefix_from_pc}")
set(private_libraries "${CMAKE_STATIC_LIBRARY_PREFIX}mdrcontact${CMAKE_STATIC_LIBRARY_SUFFIX}")
foreach(library IN LISTS LAPACK_LIBRARIES)
  get_filename_component(name "${library}" NAME_WE)
  string(REGEX REPLACE "^(-l|lib)" "" name "${name}")
  string(APPEND private_libraries " -l${name}")
endforeach()
if(CMAKE_Fortran_COMPILER_ID STREQUAL "GNU")
  string(APPEND private_libraries " -lgfortran")
endif()
if(MDRCONTACT_OPENMP AND CMAKE_Fortran_COMPILER_ID STREQUAL "GNU")
  string(APPEND private_libraries " -lgomp")
endif()
set(package_name mdrcontact)
set(package_libs "-L\${libdir} -lmdrcontact")
configure_file("${PROJECT_SOURCE_DIR}/cmake/mdrcontact.pc.in" "${CMAKE_BINARY_DIR}/mdrcontact.pc" @ONLY)
set(package_name mdrcontact-static)
set(package_words " (static, with the Fortran modules)")
set(required_packages " gsl")
set(package_cflags " -I\${includedir}/mdrcontact/modules")
set(package_libs "\${libdir}/${private_libraries} -lm")
configure_file("${PROJECT_SOURCE_DIR}/cmake/mdrcontact.pc.in" "${CMAKE_BINARY_DIR}/mdrcontact-static.pc" @ONLY)
install(FILES "${CMAKE_BINARY_DIR}/mdrcontact.pc" "${CMAKE_BINARY_DIR}/mdrcontact-static.pc"
  DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
