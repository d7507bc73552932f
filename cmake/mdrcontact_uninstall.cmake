# SPDX-License-Identifier: GPL-3.0-or-later
# Removes what the last `cmake --install` of a build folder wrote: cmake -Dmanifest=... -P mdrcontact_uninstall.cmake
if(NOT EXISTS "${manifest}")
  message(FATAL_ERROR "${manifest} does not exist: nothing was installed from this build folder")
endif()
file(STRINGS "${manifest}" files)
file(REMOVE ${files})
# Folders of ours that are empty now.
foreach(file IN LISTS files)
  get_filename_component(folder "${file}" DIRECTORY)
  while(folder MATCHES "/mdrcontact(/|$)")
    file(GLOB left "${folder}/*")
    if(left OR NOT EXISTS "${folder}")
      break()
    endif()
    file(REMOVE_RECURSE "${folder}")
    get_filename_component(folder "${folder}" DIRECTORY)
  endwhile()
endforeach()
