# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -D ADDON=… -D PACKAGE=… -D STAGE=… -P stage.cmake
# Makes STAGE hold the add-on, the Python package inside it, the licence and nothing else. Only what differs is written,
# so that file times tell what changed.
function(files_to_ship folder result)
  file(GLOB_RECURSE files RELATIVE ${folder} ${folder}/*)
  list(FILTER files EXCLUDE REGEX "__pycache__/|\\.cmake$|CMakeLists\\.txt$")
  set(${result} ${files} PARENT_SCOPE)
endfunction()

function(copy_changed source target)
  get_filename_component(folder ${target} DIRECTORY)
  file(MAKE_DIRECTORY ${folder})
  file(COPY_FILE ${source} ${target} ONLY_IF_DIFFERENT)
endfunction()

files_to_ship(${ADDON} addon_files)
files_to_ship(${PACKAGE} package_files)
file(GLOB_RECURSE stale RELATIVE ${STAGE} ${STAGE}/*)
copy_changed(${ADDON}/../LICENSE ${STAGE}/LICENSE)
list(REMOVE_ITEM stale LICENSE)
foreach(file IN LISTS addon_files)
  copy_changed(${ADDON}/${file} ${STAGE}/${file})
  list(REMOVE_ITEM stale ${file})
endforeach()
foreach(file IN LISTS package_files)
  copy_changed(${PACKAGE}/${file} ${STAGE}/dirichlet_surface/${file})
  list(REMOVE_ITEM stale dirichlet_surface/${file})
endforeach()
foreach(file IN LISTS stale)
  file(REMOVE ${STAGE}/${file})
endforeach()
