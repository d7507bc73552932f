# SPDX-License-Identifier: GPL-3.0-or-later
# The header's macros and fpm.toml against the project's version.
string(REPLACE "." ";" parts "${version}")
file(READ "${source_dir}/include/mdrcontact.h" header)
foreach(name IN ITEMS MAJOR MINOR PATCH)
  list(POP_FRONT parts part)
  if(NOT header MATCHES "#define MDR_VERSION_${name} ${part}\n")
    message(FATAL_ERROR "mdrcontact.h: MDR_VERSION_${name} is not ${part}")
  endif()
endforeach()
file(READ "${source_dir}/fpm.toml" manifest)
if(NOT manifest MATCHES "\nversion = \"${version}\"\n")
  message(FATAL_ERROR "fpm.toml: version is not ${version}")
endif()
