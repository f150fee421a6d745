# What waybreaker_version_source runs. VERSION alone where neither git nor an archive that git made knows the commit, else
# VERSION+COMMIT, as Semantic Versioning adds what was built; sources that differ from the commit add what they hash to.
set(commit_length 12)

# In archives made by git the commit stands in this file (.gitattributes).
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/commit.txt commit LIMIT_COUNT 1)
set(changes "")

if(NOT commit MATCHES "^[0-9a-f]+$")
  set(commit "")
  # Changes nothing, also where two builds look at once; no configuration of the user's matters.
  set(git ${GIT} --no-optional-locks -C ${SOURCE_DIR})
  # Of this project, and not of one that it was copied into.
  if(GIT)
    execute_process(COMMAND ${git} rev-parse --show-prefix OUTPUT_VARIABLE prefix RESULT_VARIABLE failed ERROR_QUIET
                    OUTPUT_STRIP_TRAILING_WHITESPACE)
    if(NOT failed AND prefix STREQUAL "")
      execute_process(COMMAND ${git} rev-parse --verify HEAD OUTPUT_VARIABLE commit ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
      set(compared ${git} diff HEAD --no-ext-diff --no-textconv --no-color --binary --full-index)
      set(sources CMakeLists.txt apps cmake include src studio)
      execute_process(COMMAND ${compared} --quiet -- ${sources} RESULT_VARIABLE changed ERROR_QUIET)
      if(commit AND changed EQUAL 1)
        execute_process(COMMAND ${compared} -- ${sources} COMMAND ${git} hash-object --stdin OUTPUT_VARIABLE changes
                        OUTPUT_STRIP_TRAILING_WHITESPACE)
      endif()
    endif()
  endif()
endif()

set(version ${VERSION})
if(commit)
  string(SUBSTRING ${commit} 0 ${commit_length} commit)
  string(APPEND version "+${commit}")
endif()
if(changes)
  string(SUBSTRING ${changes} 0 8 changes)
  string(APPEND version ".changed.${changes}")
endif()
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [[
// Made by the build.
#include "version.hpp"

namespace waybreaker::apps {

std::string version() {
    return "@version@";
}

}  // namespace waybreaker::apps
]])
