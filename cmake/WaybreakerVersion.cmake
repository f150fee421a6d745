# waybreaker_version_source(OUTPUT): makes the source file OUTPUT, which defines `waybreaker::apps::version()`: the version of
# the project and the commit that is built. It is looked at in every build, and the file changes only with the answer: a
# new commit compiles one file and links one program.
find_package(Git QUIET)
set(WAYBREAKER_VERSION_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/version.cmake)

function(waybreaker_version_source output)
  add_custom_target(waybreaker_version
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DVERSION=${PROJECT_VERSION} -DSOURCE_DIR=${PROJECT_SOURCE_DIR}
            -DGIT=${GIT_EXECUTABLE} -P ${WAYBREAKER_VERSION_SCRIPT}
    BYPRODUCTS ${output}
    VERBATIM)
endfunction()
