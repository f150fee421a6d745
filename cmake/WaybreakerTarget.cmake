# All targets of the project are defined here, so that warnings and sanitizers are the same everywhere.

set(WAYBREAKER_SANITIZE "" CACHE STRING "Sanitizers for every target, e.g. address,undefined")
option(WAYBREAKER_COVERAGE "Instrument for gcov" OFF)
option(WAYBREAKER_PRECOMPILE "Precompile the headers of large libraries" ON)

function(waybreaker_flags target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion
                         -Wnon-virtual-dtor -Woverloaded-virtual $<$<CXX_COMPILER_ID:Clang>:-Wreserved-identifier>)
  # The last bit of a time is the same on processors with and without fused multiply-add.
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  if(WAYBREAKER_WARNINGS_ARE_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(WAYBREAKER_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${WAYBREAKER_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    # It opens a pipe to look at an object, and takes it for none where no file can be opened, as some tests want it.
    target_compile_options(${target} PRIVATE -fno-sanitize=vptr)
    target_link_options(${target} PRIVATE -fsanitize=${WAYBREAKER_SANITIZE})
  endif()
  if(WAYBREAKER_COVERAGE)
    target_compile_options(${target} PRIVATE --coverage)
    target_link_options(${target} PRIVATE --coverage)
  endif()
endfunction()

# By default, Clang writes timestamps into precompiled headers, so that ccache would never find them again.
function(waybreaker_timeless target)
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>)
endfunction()

# waybreaker_precompile(TARGET header...): headers of others that many files of the target include. Each file still names
# what it needs: the presets without precompiled headers fail where one does not.
function(waybreaker_precompile target)
  if(WAYBREAKER_PRECOMPILE)
    target_precompile_headers(${target} PRIVATE ${ARGN})
    waybreaker_timeless(${target})
  endif()
endfunction()

# The same as for another target, whose precompiled headers are used.
function(waybreaker_precompile_as other target)
  if(WAYBREAKER_PRECOMPILE)
    target_precompile_headers(${target} REUSE_FROM ${other})
    waybreaker_timeless(${target})
  endif()
endfunction()

# Hardly optimised: for code whose speed nobody feels, while what its headers bring takes long to compile.
function(waybreaker_compile_quickly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# waybreaker_library(NAME SOURCES file... [USES folder...] [NEEDS library...])
# One static library per folder of src/. It can include its own folder, the public headers, and the folders it USES: a
# forbidden use fails to link, and tests/architecture fails on a forbidden #include.
function(waybreaker_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES;NEEDS" ${ARGN})
  set(target waybreaker_${name})
  add_library(${target} STATIC ${ARG_SOURCES})
  add_library(waybreaker::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                             $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
                             $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>)
  foreach(used IN LISTS ARG_USES)
    target_link_libraries(${target} PUBLIC waybreaker_${used})
  endforeach()
  target_link_libraries(${target} PRIVATE ${ARG_NEEDS})
  waybreaker_flags(${target})
endfunction()
