# Rasterizers that nobody here wrote, as plugins in build/plugins/. Their packages are optional
# (packages-subjects.apt): a subject whose package is missing is said to be so, and left out.
# Nothing of this belongs to `all`: the target real_subjects builds what there is.
find_package(PkgConfig)
add_custom_target(real_subjects)

function(rasterproof_missing_subject name install)
  message(STATUS "subject ${name}: not available (install ${install})")
endfunction()

# rasterproof_real_subject(NAME SOURCES a.cc ... LINK target ... [DEFINITIONS a=b ...])
function(rasterproof_real_subject name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK;DEFINITIONS" ${ARGN})
  add_library(plugin_${name} MODULE EXCLUDE_FROM_ALL ${ARG_SOURCES})
  target_link_libraries(plugin_${name} PRIVATE rasterproof_flags ${ARG_LINK})
  target_compile_definitions(plugin_${name} PRIVATE ${ARG_DEFINITIONS})
  set_target_properties(plugin_${name} PROPERTIES
    PREFIX "" OUTPUT_NAME ${name} CXX_VISIBILITY_PRESET hidden
    LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/plugins)
  add_dependencies(real_subjects plugin_${name})
endfunction()

# Several samples a pixel: not surveyed, whose table is of centres, but checked.
function(rasterproof_multisampled name)
  set_target_properties(plugin_${name} PROPERTIES
    LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/plugins/multisampled)
endfunction()

# rasterproof_subject_package(VARIABLE SUBJECT INSTALL module ...): pkg-config's modules as the
# target PkgConfig::VARIABLE, or a line that says what to install; VARIABLE_FOUND tells which.
macro(rasterproof_subject_package variable subject install)
  if(PkgConfig_FOUND)
    pkg_check_modules(${variable} QUIET IMPORTED_TARGET ${ARGN})
  endif()
  if(NOT ${variable}_FOUND)
    rasterproof_missing_subject(${subject} "${install}")
  endif()
endmacro()

# A GPU, through its own drivers. Whether there is one shows in its device files.
option(RASTERPROOF_GPU_SUBJECTS "Build the subjects of a GPU where there is none, to run elsewhere")
file(GLOB gpu /dev/dri/renderD* /dev/nvidia[0-9]*)
if(RASTERPROOF_GPU_SUBJECTS)
  set(gpu ON)
endif()
if(NOT gpu)
  message(STATUS "subject gl-gpu, vulkan-gpu: not available (no GPU at /dev/dri or /dev/nvidia*)")
endif()

rasterproof_subject_package(SUBJECT_GL gl "libegl-dev libopengl-dev libgl1-mesa-dri" egl opengl)
if(SUBJECT_GL_FOUND)
  # rasterproof_gl_subject(NAME DRIVER SUBMISSION [SAMPLES n] [DEFINITION ...])
  function(rasterproof_gl_subject name driver submission)
    cmake_parse_arguments(GL "" "SAMPLES" "" ${ARGN})
    if(NOT GL_SAMPLES)
      set(GL_SAMPLES 1)
    endif()
    rasterproof_real_subject(${name}
      SOURCES
        subjects/gl/gl.cc subjects/gl/counter.cc subjects/gl/context.cc subjects/gl/interpolator.cc
        subjects/gl/program.cc subjects/gl/sample_fetcher.cc subjects/shaded/shaded.cc
      LINK PkgConfig::SUBJECT_GL
      DEFINITIONS
        RASTERPROOF_GL_NAME="${name}" RASTERPROOF_GL_DRIVER="${driver}"
        RASTERPROOF_GL_SUBMISSION=k${submission}
        RASTERPROOF_GL_SAMPLES=${GL_SAMPLES} RASTERPROOF_GL_SAMPLES_TEXT="${GL_SAMPLES}"
        ${GL_UNPARSED_ARGUMENTS})
  endfunction()
  foreach(submission Batch Alone)
    string(TOLOWER ${submission} ending)
    rasterproof_gl_subject(gl-llvmpipe-${ending} llvmpipe ${submission})
    rasterproof_gl_subject(gl-softpipe-${ending} softpipe ${submission}
      RASTERPROOF_GL_SNAPS_NOTHING)
    if(gpu)
      rasterproof_gl_subject(gl-gpu-${ending} "" ${submission})
    endif()
  endforeach()
  rasterproof_gl_subject(gl-llvmpipe-4x llvmpipe Batch SAMPLES 4)
  rasterproof_multisampled(gl-llvmpipe-4x)
  if(gpu)
    rasterproof_gl_subject(gl-gpu-4x "" Batch SAMPLES 4)
    rasterproof_multisampled(gl-gpu-4x)
  endif()
  # Its division as well: not surveyed, whose scenes are window space, but certified.
  function(rasterproof_gl_clip_subject name driver)
    rasterproof_gl_subject(${name} "${driver}" Batch RASTERPROOF_GL_CLIP_SPACE ${ARGN})
    set_target_properties(plugin_${name} PROPERTIES
      LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/plugins/clip_space)
  endfunction()
  rasterproof_gl_clip_subject(gl-llvmpipe-clip llvmpipe)
  rasterproof_gl_clip_subject(gl-llvmpipe-values llvmpipe RASTERPROOF_GL_SHOWS_VALUES)
  rasterproof_gl_clip_subject(
    gl-llvmpipe-values-4x llvmpipe RASTERPROOF_GL_SHOWS_VALUES SAMPLES 4)
  rasterproof_gl_clip_subject(gl-softpipe-values softpipe RASTERPROOF_GL_SHOWS_VALUES)
  if(gpu)
    rasterproof_gl_clip_subject(gl-gpu-clip "")
    rasterproof_gl_clip_subject(gl-gpu-values "" RASTERPROOF_GL_SHOWS_VALUES)
    rasterproof_gl_clip_subject(gl-gpu-values-4x "" RASTERPROOF_GL_SHOWS_VALUES SAMPLES 4)
  endif()
endif()

find_program(GLSLANG glslangValidator)
if(GLSLANG)
  rasterproof_subject_package(SUBJECT_VULKAN vulkan "libvulkan-dev glslang-tools" vulkan)
else()
  rasterproof_missing_subject(vulkan "glslang-tools libvulkan-dev")
endif()
if(SUBJECT_VULKAN_FOUND)
  set(shaders ${PROJECT_BINARY_DIR}/shaders)
  foreach(shader triangle.vert triangle.frag values.vert values.frag read_samples.comp)
    string(REGEX MATCH "[a-z]+$" stage ${shader})
    string(REPLACE vert Vertex stage ${stage})
    string(REPLACE frag Fragment stage ${stage})
    string(REPLACE comp Compute stage ${stage})
    add_custom_command(OUTPUT ${shaders}/${shader}.h
      COMMAND ${CMAKE_COMMAND} -E make_directory ${shaders}
      COMMAND ${GLSLANG} -V --quiet --vn k${stage}Shader -o ${shaders}/${shader}.h
        ${PROJECT_SOURCE_DIR}/subjects/vulkan/${shader}
      DEPENDS subjects/vulkan/${shader} VERBATIM)
  endforeach()
  add_custom_command(OUTPUT ${shaders}/sample_values.frag.h
    COMMAND ${GLSLANG} -V --quiet -DEACH_SAMPLE --vn kSampleFragmentShader
      -o ${shaders}/sample_values.frag.h ${PROJECT_SOURCE_DIR}/subjects/vulkan/values.frag
    DEPENDS subjects/vulkan/values.frag ${shaders}/values.frag.h VERBATIM)
  set(shader_headers
    ${shaders}/triangle.vert.h ${shaders}/triangle.frag.h ${shaders}/values.vert.h
    ${shaders}/values.frag.h ${shaders}/sample_values.frag.h ${shaders}/read_samples.comp.h)
  add_custom_target(vulkan_shaders DEPENDS ${shader_headers})
  # rasterproof_vulkan_subject(NAME INSTALL DESCRIPTION DEVICE HALF_VIEWPORT [SAMPLES [DEFINITION]])
  # An empty description: the drivers that are installed, and any GPU.
  function(rasterproof_vulkan_subject name install description device half)
    set(samples 1)
    if(ARGC GREATER 5)
      set(samples ${ARGV5})
    endif()
    file(GLOB found ${description})
    if(description AND NOT found)
      rasterproof_missing_subject(${name} ${install})
      return()
    endif()
    rasterproof_real_subject(${name}
      SOURCES
        subjects/vulkan/vulkan.cc subjects/vulkan/counter.cc subjects/vulkan/interpolator.cc
        subjects/vulkan/painter.cc subjects/vulkan/sample_reader.cc subjects/shaded/shaded.cc
        ${shader_headers}
      LINK PkgConfig::SUBJECT_VULKAN
      DEFINITIONS
        RASTERPROOF_VULKAN_NAME="${name}" RASTERPROOF_VULKAN_ICD="${found}"
        RASTERPROOF_VULKAN_DEVICE="${device}"
        RASTERPROOF_VULKAN_HALF_VIEWPORT=${half} RASTERPROOF_VULKAN_SAMPLES=${samples} ${ARGV6})
    target_include_directories(plugin_${name} PRIVATE ${shaders})
    if(samples GREATER 1)
      rasterproof_multisampled(${name})
    endif()
  endfunction()
  foreach(samples 1 4)
    set(ending "")
    if(samples GREATER 1)
      set(ending -${samples}x)
    endif()
    rasterproof_vulkan_subject(vulkan-lavapipe${ending} mesa-vulkan-drivers
      "/usr/share/vulkan/icd.d/lvp_icd.*.json" llvmpipe 8192 ${samples})
    rasterproof_vulkan_subject(vulkan-swiftshader${ending} chromium-common
      /usr/lib/chromium/vk_swiftshader_icd.json SwiftShader 4096 ${samples})
  endforeach()
  # Clip space is theirs to divide: beside the subjects that do so.
  function(rasterproof_vulkan_values name install description device half)
    foreach(samples 1 4)
      set(ending "")
      if(samples GREATER 1)
        set(ending -${samples}x)
      endif()
      rasterproof_vulkan_subject(${name}${ending} "${install}" "${description}" "${device}" ${half}
        ${samples} RASTERPROOF_VULKAN_SHOWS_VALUES)
      if(TARGET plugin_${name}${ending})
        set_target_properties(plugin_${name}${ending} PROPERTIES
          LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/plugins/clip_space)
      endif()
    endforeach()
  endfunction()
  rasterproof_vulkan_values(vulkan-lavapipe-values mesa-vulkan-drivers
    "/usr/share/vulkan/icd.d/lvp_icd.*.json" llvmpipe 8192)
  rasterproof_vulkan_values(vulkan-swiftshader-values chromium-common
    /usr/lib/chromium/vk_swiftshader_icd.json SwiftShader 4096)
  if(gpu)
    rasterproof_vulkan_subject(vulkan-gpu "" "" "" 8192)
    rasterproof_vulkan_values(vulkan-gpu-values "" "" "" 8192)
    foreach(samples 2 4 8)
      rasterproof_vulkan_subject(vulkan-gpu-${samples}x "" "" "" 8192 ${samples})
    endforeach()
  endif()
endif()

rasterproof_subject_package(SUBJECT_SDL2 sdl2 libsdl2-dev sdl2)
if(SUBJECT_SDL2_FOUND)
  rasterproof_real_subject(sdl2
    SOURCES subjects/sdl2/sdl2.cc LINK PkgConfig::SUBJECT_SDL2
    DEFINITIONS RASTERPROOF_SDL2_BATCH=false)
  rasterproof_real_subject(sdl2-batch
    SOURCES subjects/sdl2/sdl2.cc LINK PkgConfig::SUBJECT_SDL2
    DEFINITIONS RASTERPROOF_SDL2_BATCH=true)
endif()

# One source file, one plugin.
macro(rasterproof_simple_subject name folder variable install)
  rasterproof_subject_package(${variable} ${name} ${install} ${ARGN})
  if(${variable}_FOUND)
    rasterproof_real_subject(${name}
      SOURCES subjects/${folder}/${folder}.cc LINK PkgConfig::${variable})
  endif()
endmacro()

rasterproof_simple_subject(pixman pixman SUBJECT_PIXMAN libpixman-1-dev pixman-1)
rasterproof_simple_subject(cairo cairo SUBJECT_CAIRO libcairo2-dev cairo)
rasterproof_simple_subject(freetype-mono freetype SUBJECT_FREETYPE libfreetype-dev freetype2)
rasterproof_simple_subject(qt5 qt SUBJECT_QT qtbase5-dev Qt5Gui)
rasterproof_simple_subject(allegro5 allegro SUBJECT_ALLEGRO liballegro5-dev
  allegro-5 allegro_primitives-5)
rasterproof_simple_subject(gd gd SUBJECT_GD libgd-dev gdlib)

# OpenCV's description for pkg-config comes with all of its modules only.
find_path(OPENCV_HEADERS opencv2/imgproc.hpp PATH_SUFFIXES opencv4)
find_library(OPENCV_CORE opencv_core)
find_library(OPENCV_IMGPROC opencv_imgproc)
if(OPENCV_HEADERS AND OPENCV_CORE AND OPENCV_IMGPROC)
  rasterproof_real_subject(opencv
    SOURCES subjects/opencv/opencv.cc LINK ${OPENCV_IMGPROC} ${OPENCV_CORE})
  target_include_directories(plugin_opencv SYSTEM PRIVATE ${OPENCV_HEADERS})
else()
  rasterproof_missing_subject(opencv libopencv-imgproc-dev)
endif()

# Programs on pipes, described rather than built.
find_program(NODE node)
find_program(NPM npm)
if(NODE AND EXISTS ${PROJECT_SOURCE_DIR}/subjects/canvaskit/node_modules/canvaskit-wasm)
  foreach(mode paths vertices)
    configure_file(subjects/canvaskit/canvaskit.subject.in plugins/canvaskit-${mode}.subject @ONLY)
  endforeach()
elseif(NODE AND NPM)
  rasterproof_missing_subject(canvaskit "its modules: npm ci --prefix subjects/canvaskit")
else()
  rasterproof_missing_subject(canvaskit "nodejs npm")
endif()
