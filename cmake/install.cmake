# What `cmake --install` and `cpack` install, and the package that find_package(rasterproof) finds:
#
#   rasterize  exact coverage as a library           rasterproof::rasterize
#   oracle     the oracle in C, shared and static    rasterproof::oracle, rasterproof::oracle_static
#   kit        the C interface of a plugin           rasterproof::kit, rasterproof_add_test()
#   gtest      properties as GoogleTest cases        rasterproof::gtest (needs GTest)
#   fuzz       fuzz targets of your own              rasterproof::fuzz_target
#
# Nothing installed holds a path of this machine: the prefix can be moved.
include(GNUInstallDirs)
set(rasterproof_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/rasterproof)

# rasterproof_install_headers(HEADER ...): these and what they include, below include/rasterproof.
# There each includes the others by relative paths: <rasterproof/library/rasterize.h> needs include/
# alone.
function(rasterproof_install_headers)
  if(NOT RASTERPROOF_INSTALL)
    return()
  endif()
  set(headers ${ARGN})
  while(headers)
    list(POP_FRONT headers header)
    get_property(done GLOBAL PROPERTY rasterproof_installed_headers)
    if(header IN_LIST done)
      continue()
    endif()
    set_property(GLOBAL APPEND PROPERTY rasterproof_installed_headers ${header})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${header})
    file(READ ${PROJECT_SOURCE_DIR}/${header} text)
    string(REGEX MATCHALL "#include \"[^\"\n]+\"" includes "${text}")
    get_filename_component(folder ${header} DIRECTORY)
    foreach(include ${includes})
      string(REGEX REPLACE "^#include \"(.*)\"$" "\\1" included "${include}")
      list(APPEND headers ${included})
      file(RELATIVE_PATH near /${folder} /${included})
      string(REPLACE "${include}" "#include \"${near}\"" text "${text}")
    endforeach()
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/installed/${header} CONTENT "${text}" @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/installed/${header}
      DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/rasterproof/${folder})
  endwhile()
endfunction()

# All that is installed is built by `cmake --build build --target rasterproof_parts`, and by
# `./run build`: nothing else, no tests and no examples.
if(RASTERPROOF_INSTALL)
  add_custom_target(rasterproof_parts)
endif()

# rasterproof_component(NAME TARGETS target ... [HEADERS header ...]): of the installed package and,
# for find_package() with rasterproof_DIR, of the one that is this build tree.
function(rasterproof_component name)
  cmake_parse_arguments(ARG "" "" "TARGETS;HEADERS" ${ARGN})
  if(NOT RASTERPROOF_INSTALL)
    return()
  endif()
  add_dependencies(rasterproof_parts ${ARG_TARGETS})
  install(TARGETS ${ARG_TARGETS} EXPORT rasterproof-${name}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(EXPORT rasterproof-${name} NAMESPACE rasterproof::
    DESTINATION ${rasterproof_package_dir})
  export(EXPORT rasterproof-${name} NAMESPACE rasterproof::
    FILE ${PROJECT_BINARY_DIR}/rasterproof-${name}.cmake)
  rasterproof_install_headers(${ARG_HEADERS})
endfunction()

# rasterproof_package(): the files of the package itself. While the first number of a version is 0 a
# package of another second number is another one.
function(rasterproof_package)
  if(NOT RASTERPROOF_INSTALL)
    return()
  endif()
  include(CMakePackageConfigHelpers)
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/rasterproof-config-version.cmake
    COMPATIBILITY SameMinorVersion)
  install(FILES
    ${PROJECT_SOURCE_DIR}/cmake/rasterproof-config.cmake
    ${PROJECT_SOURCE_DIR}/cmake/rasterproof-add-test.cmake
    ${PROJECT_BINARY_DIR}/rasterproof-config-version.cmake
    DESTINATION ${rasterproof_package_dir})
  foreach(file rasterproof-config.cmake rasterproof-add-test.cmake)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/${file} ${PROJECT_BINARY_DIR}/${file} COPYONLY)
  endforeach()
endfunction()
