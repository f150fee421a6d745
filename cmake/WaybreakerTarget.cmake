# All targets of the project are defined here, so that warnings and sanitizers are the same everywhere.

set(WAYBREAKER_SANITIZE "" CACHE STRING "Sanitizers for every target, e.g. address,undefined")
option(WAYBREAKER_COVERAGE "Instrument for gcov" OFF)
option(WAYBREAKER_PRECOMPILE "Precompile the headers of large libraries" ON)

function(waybreaker_flags target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion
                         $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor -Woverloaded-virtual>
                         $<$<COMPILE_LANG_AND_ID:CXX,Clang>:-Wreserved-identifier>)
  # The last bit of a time is the same on processors with and without fused multiply-add.
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  # What is compiled is the same wherever the clone lies: so ccache finds it again in another.
  target_compile_options(${target} PRIVATE -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=)
  if(WAYBREAKER_WARNINGS_ARE_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(WAYBREAKER_SANITIZE)
    # C may be compiled by another compiler, with another runtime.
    target_compile_options(${target} PRIVATE
      $<$<COMPILE_LANGUAGE:CXX>:-fsanitize=${WAYBREAKER_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer>)
    # It opens a pipe to look at an object, and takes it for none where no file can be opened, as some tests want it.
    target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-fno-sanitize=vptr>)
    target_link_options(${target} PRIVATE -fsanitize=${WAYBREAKER_SANITIZE})
  endif()
  if(WAYBREAKER_COVERAGE)
    target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:--coverage>)
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

# waybreaker_combined_library(TARGET NAME FOLDERS folder... EXPORTS script SOVERSION number): all these folders in one
# library, waybreaker::NAME, for programs of others. If it is shared, it shows what the version script in cmake/ lists.
function(waybreaker_combined_library target name)
  cmake_parse_arguments(ARG "" "EXPORTS;SOVERSION" "FOLDERS" ${ARGN})
  add_library(${target})
  add_library(waybreaker::${name} ALIAS ${target})
  foreach(folder IN LISTS ARG_FOLDERS)
    get_target_property(type waybreaker_${folder} TYPE)
    if(NOT type STREQUAL INTERFACE_LIBRARY)
      target_sources(${target} PRIVATE $<TARGET_OBJECTS:waybreaker_${folder}>)
    endif()
  endforeach()
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                             $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  waybreaker_flags(${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} LINKER_LANGUAGE CXX VERSION ${PROJECT_VERSION}
                        SOVERSION ${ARG_SOVERSION})
  if(BUILD_SHARED_LIBS AND NOT APPLE)
    set(exports ${PROJECT_SOURCE_DIR}/cmake/${ARG_EXPORTS})
    target_link_options(${target} PRIVATE LINKER:--version-script=${exports} LINKER:--no-undefined)
    set_target_properties(${target} PROPERTIES LINK_DEPENDS ${exports})
  endif()
endfunction()

# waybreaker_library(NAME SOURCES file... [USES folder...] [NEEDS library...])
# One static library per folder of src/. It can include its own folder, the public headers, and the folders it USES: a
# forbidden use fails to link, and tests/architecture fails on a forbidden #include.
function(waybreaker_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES;NEEDS" ${ARGN})
  set(target waybreaker_${name})
  add_library(${target} STATIC ${ARG_SOURCES})
  add_library(waybreaker::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  if(NOT CMAKE_SYSTEM_PROCESSOR STREQUAL wasm32)  # which has no shared libraries
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  endif()
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
