# `cpack -G DEB` in a build tree: one package with the command, its scenes, the kit, both libraries
# and the documents. `cmake --install` installs the same below any prefix.
set(doc ${CMAKE_INSTALL_DATADIR}/doc/rasterproof)
install(FILES cmake/package/copyright DESTINATION ${doc})
install(FILES cmake/package/lintian-overrides DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides
  RENAME rasterproof)
install(DIRECTORY kit/examples DESTINATION ${doc})

# The documents, with links to what is installed alone, and Debian's changelog. gzip -n: the same
# bytes from the same text.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(installed ${PROJECT_BINARY_DIR}/installed)
file(GLOB_RECURSE documents CONFIGURE_DEPENDS docs/*)
add_custom_command(OUTPUT ${installed}/documents.stamp
  COMMAND Python3::Interpreter -B ${PROJECT_SOURCE_DIR}/scripts/installed_docs
    ${installed}/documents ${installed}/changelog
  COMMAND gzip -9nf ${installed}/changelog
  COMMAND ${CMAKE_COMMAND} -E touch ${installed}/documents.stamp
  DEPENDS ${documents} README.md CHANGELOG.md scripts/installed_docs VERBATIM)
add_custom_target(rasterproof_documents ALL DEPENDS ${installed}/documents.stamp)
add_dependencies(rasterproof_parts rasterproof_documents)
install(DIRECTORY ${installed}/documents/ DESTINATION ${doc})
install(FILES ${installed}/changelog.gz DESTINATION ${doc})

# gzip -n: the same bytes from the same text.
function(rasterproof_install_compressed source name destination)
  set(made ${PROJECT_BINARY_DIR}/installed/${name}.gz)
  configure_file(${source} ${PROJECT_BINARY_DIR}/installed/${name} @ONLY)
  execute_process(COMMAND gzip -9nc ${PROJECT_BINARY_DIR}/installed/${name}
    OUTPUT_FILE ${made} COMMAND_ERROR_IS_FATAL ANY)
  install(FILES ${made} DESTINATION ${destination})
endfunction()
rasterproof_install_compressed(cmake/package/rasterproof.1 rasterproof.1
  ${CMAKE_INSTALL_MANDIR}/man1)

# The browser's page, if ./run web has built it.
install(FILES build-web/passport.html DESTINATION ${CMAKE_INSTALL_DATADIR}/rasterproof OPTIONAL)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR rasterproof)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "the authors of rasterproof <rasterproof@example.org>")
set(CPACK_DEBIAN_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "verification of triangle rasterizers against exact arithmetic
Properties of any triangle rasterizer on generated cases, judged by exact
arithmetic: a shared library, a program on a pipe, or a C++ type. Exact
coverage as a library; properties as GoogleTest cases and as fuzz targets.")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
# libassimp5 is loaded when a mesh is read: dpkg-shlibdeps does not see it.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libassimp5, python3:any")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/package/triggers)
# glmark2-data: the mesh that certify draws.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS
  "g++, cmake, glmark2-data, libgtest-dev, python3-numpy")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS
  "libgmp-dev, libmpfr-dev, picosat, clang-19, python3-hypothesis, python3-pytest")
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
if(TARGET rasterproof_oracle) # a tree for fuzzing has none
  include(cmake/python.cmake)
endif()
include(CPack)
