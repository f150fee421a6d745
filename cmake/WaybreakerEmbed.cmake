# waybreaker_embed(OUTPUT NAMESPACE name SYMBOLS symbol... FILES file...)
# Makes the source file OUTPUT, which defines `std::string_view symbol()` with the bytes of each file, in order. Files may
# be made by the build; declare the functions in a header of your own.
set(WAYBREAKER_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/embed.cmake)

function(waybreaker_embed output)
  cmake_parse_arguments(ARG "" "NAMESPACE" "SYMBOLS;FILES" ${ARGN})
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DNAMESPACE=${ARG_NAMESPACE} "-DSYMBOLS=${ARG_SYMBOLS}" "-DFILES=${ARG_FILES}"
            -P ${WAYBREAKER_EMBED_SCRIPT}
    DEPENDS ${ARG_FILES} ${WAYBREAKER_EMBED_SCRIPT}
    VERBATIM)
endfunction()
