# rasterproof_add_test(NAME name {PLUGIN target-or-file | PROGRAM command | SUBJECT file}
#                      [PROFILE profile] [CASES n] [SEED seed] [PROPERTIES property ...]
#                      [OPTIONS option ...])
#
# A test of ctest that runs `rasterproof check` on a rasterizer: a plugin of this build or in a
# file, a program that answers on a pipe, or a description (*.subject). It fails where a property
# is violated, and where the contract was not put to the test. OPTIONS go to the command as they
# are.
function(rasterproof_add_test)
  cmake_parse_arguments(ARG "" "NAME;PLUGIN;PROGRAM;SUBJECT;PROFILE;CASES;SEED" "PROPERTIES;OPTIONS"
    ${ARGN})
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR
      "rasterproof_add_test: ${ARG_UNPARSED_ARGUMENTS} is no argument; there are NAME, PLUGIN, "
      "PROGRAM, SUBJECT, PROFILE, CASES, SEED, PROPERTIES and OPTIONS")
  endif()
  set(subjects ${ARG_PLUGIN} ${ARG_PROGRAM} ${ARG_SUBJECT})
  list(LENGTH subjects count)
  if(NOT ARG_NAME OR NOT count EQUAL 1)
    message(FATAL_ERROR
      "rasterproof_add_test: give NAME, and one of PLUGIN, PROGRAM and SUBJECT")
  endif()
  set(command rasterproof)
  if(TARGET rasterproof::rasterproof)
    set(command rasterproof::rasterproof)
  endif()
  if(TARGET "${ARG_PLUGIN}")
    list(APPEND options --plugin $<TARGET_FILE:${ARG_PLUGIN}>)
  elseif(ARG_PLUGIN)
    list(APPEND options --plugin ${ARG_PLUGIN})
  elseif(TARGET "${ARG_PROGRAM}")
    list(APPEND options --exec $<TARGET_FILE:${ARG_PROGRAM}>)
  elseif(ARG_PROGRAM)
    list(APPEND options --exec ${ARG_PROGRAM})
  else()
    # A relative path is the source folder's if the file is there, else the build folder's, where a
    # GoogleTest suite writes its own when its tests are discovered.
    get_filename_component(subject ${ARG_SUBJECT} ABSOLUTE)
    if(NOT EXISTS ${subject})
      get_filename_component(subject ${ARG_SUBJECT} ABSOLUTE BASE_DIR ${CMAKE_CURRENT_BINARY_DIR})
    endif()
    list(APPEND options --subject ${subject})
  endif()
  foreach(option PROFILE CASES SEED)
    if(DEFINED ARG_${option})
      string(TOLOWER --${option} name)
      list(APPEND options ${name} ${ARG_${option}})
    endif()
  endforeach()
  foreach(property ${ARG_PROPERTIES})
    list(APPEND options --property ${property})
  endforeach()
  add_test(NAME ${ARG_NAME} COMMAND ${command} check ${options} ${ARG_OPTIONS})
endfunction()
