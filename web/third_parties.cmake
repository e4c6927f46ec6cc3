# Headers of third parties: of the host those that are for every machine, by links, because the
# host's own libc lies beside them. PicoSAT comes as its source, which Debian's package is made of.
set(third ${PROJECT_BINARY_DIR}/third_parties)
file(MAKE_DIRECTORY ${third})
foreach(folder boost Random123 nlohmann hwy)
  find_path(${folder}_INCLUDE ${folder} PATHS /usr/include NO_CMAKE_FIND_ROOT_PATH REQUIRED)
  file(CREATE_LINK ${${folder}_INCLUDE}/${folder} ${third}/${folder} SYMBOLIC)
endforeach()
target_include_directories(rasterproof_flags SYSTEM INTERFACE ${third})
# Sizes have 32 bits here: -Wconversion names each place where 64 bits become a size.
target_compile_options(rasterproof_flags INTERFACE -msimd128 -mbulk-memory -mnontrapping-fptoint
  -Wno-unused-command-line-argument) # -fno-semantic-interposition
target_compile_definitions(rasterproof_flags INTERFACE
  # Boost 1.74 asks for std::unary_function.
  _LIBCPP_ENABLE_CXX17_REMOVED_UNARY_BINARY_FUNCTION)
add_library(Threads::Threads INTERFACE IMPORTED GLOBAL)
add_library(nlohmann_json::nlohmann_json INTERFACE IMPORTED GLOBAL)

set(HIGHWAY_INCLUDE ${third})

set(picosat_archive ${third}/picosat_965.orig.tar.gz)
file(DOWNLOAD http://deb.debian.org/debian/pool/main/p/picosat/picosat_965.orig.tar.gz
  ${picosat_archive}
  EXPECTED_HASH SHA256=15169b4f28ba8f628f353f6f75a100845cdef4a2244f101a02b6e5a26e46a754)
file(ARCHIVE_EXTRACT INPUT ${picosat_archive} DESTINATION ${third})
file(CREATE_LINK ${third}/picosat-965 ${third}/picosat SYMBOLIC)
# It includes <sys/unistd.h>, which is glibc's name.
file(WRITE ${third}/for_picosat/sys/unistd.h "#include <unistd.h>\n")
add_library(rasterproof_picosat STATIC ${third}/picosat/picosat.c)
target_compile_definitions(rasterproof_picosat PRIVATE NDEBUG _WASI_EMULATED_PROCESS_CLOCKS)
target_compile_options(rasterproof_picosat PRIVATE -w)
target_include_directories(rasterproof_picosat PRIVATE ${third}/for_picosat)
set(PICOSAT_LIBRARY rasterproof_picosat)
