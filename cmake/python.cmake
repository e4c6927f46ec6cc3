# The Python package (kit/python): `cmake --install` puts it below lib/python3/dist-packages. The
# target `python_wheel` makes a wheel of it, by pip, setuptools and wheel, without a network.
set(python_sources ${PROJECT_SOURCE_DIR}/kit/python)
set(python_folder lib/python3/dist-packages)
install(DIRECTORY ${python_sources}/rasterproof DESTINATION ${python_folder}
  FILES_MATCHING PATTERN "*.py" PATTERN "__pycache__" EXCLUDE)
foreach(file METADATA entry_points.txt)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/package/${file}.in
    ${PROJECT_BINARY_DIR}/installed/dist-info/${file} @ONLY)
endforeach()
install(DIRECTORY ${PROJECT_BINARY_DIR}/installed/dist-info/
  DESTINATION ${python_folder}/rasterproof-${PROJECT_VERSION}.dist-info)

# In a wheel the libraries lie beside the modules.
find_program(RASTERPROOF_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH) # Debian's has its packages
find_program(RASTERPROOF_PYTHON python3)
set(wheel ${PROJECT_BINARY_DIR}/wheel)
set(wheel_package ${wheel}/tree/rasterproof)
get_filename_component(picosat_file ${PICOSAT_SHARED_LIBRARY} REALPATH)
add_custom_target(python_wheel
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${wheel}
  COMMAND ${CMAKE_COMMAND} -E copy_directory ${python_sources} ${wheel}/tree
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${wheel_package}/__pycache__
  COMMAND ${CMAKE_COMMAND} -E copy $<TARGET_FILE:rasterproof_oracle>
    ${wheel_package}/librasterproof_oracle.so.1
  COMMAND ${CMAKE_COMMAND} -E copy ${picosat_file} ${wheel_package}/libpicosat.so.1
  COMMAND ${CMAKE_COMMAND} -E copy ${PROJECT_SOURCE_DIR}/cmake/package/copyright
    ${wheel_package}/copyright
  COMMAND ${RASTERPROOF_PYTHON} -m pip wheel --quiet --no-build-isolation --no-deps --no-index
    --wheel-dir ${wheel} ${wheel}/tree
  COMMENT "Building the wheel in ${wheel}"
  VERBATIM)
add_dependencies(python_wheel rasterproof_oracle)
