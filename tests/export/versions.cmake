# SPDX-License-Identifier: GPL-3.0-or-later
# The header's macros, fpm.toml, CITATION.cff, recipes/ and the newest heading of CHANGELOG.md against the project's version, and the
# date of a release.
string(REPLACE "." ";" parts "${version}")
string(REPLACE "." "\\." pattern "${version}")

# expect(file wanted): the file has a line that matches.
function(expect file wanted)
  file(READ "${source_dir}/${file}" text)
  if(NOT "\n${text}" MATCHES "\n${wanted}\n")
    message(FATAL_ERROR "${file}: no line ${wanted}; the version is ${version}")
  endif()
endfunction()

foreach(name IN ITEMS MAJOR MINOR PATCH)
  list(POP_FRONT parts part)
  expect(include/mdrcontact/base.h "#define MDR_VERSION_${name} ${part}")
endforeach()
expect(fpm.toml "version = \"${pattern}\"")
expect(CITATION.cff "version: ${pattern}")
expect(recipes/conda/recipe.yaml "  version: \"${pattern}\"")
expect(recipes/spack/package.py "    version\\(\"${pattern}\"\\)")

file(STRINGS "${source_dir}/CHANGELOG.md" headings REGEX "^## ")
list(GET headings 0 newest)
if(NOT newest MATCHES "^## \\[${pattern}\\] - (unreleased|[0-9][0-9][0-9][0-9]-[0-9][0-9]-[0-9][0-9])$")
  message(FATAL_ERROR "CHANGELOG.md: the newest heading is \"${newest}\"; the version is ${version}")
endif()
# a released version is cited with its date
if(NOT CMAKE_MATCH_1 STREQUAL "unreleased")
  expect(CITATION.cff "date-released: ${CMAKE_MATCH_1}")
endif()
