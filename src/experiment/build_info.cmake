# Writes what a binary says about itself; run at every build, touches the file only when something changed.
execute_process(COMMAND git rev-parse --short=8 HEAD WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE commit
  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
set(dirty false)
if(failed)
  set(commit unknown)
else()
  execute_process(COMMAND git status --porcelain --untracked-files=no WORKING_DIRECTORY ${SOURCE}
    OUTPUT_VARIABLE changes ERROR_QUIET)
  if(changes)
    set(dirty true)
  endif()
endif()
string(STRIP "${FLAGS}" FLAGS)
set(text "#pragma once
#define FACET_COMMIT \"${commit}\"
#define FACET_DIRTY ${dirty}
#define FACET_VERSION \"${VERSION}\"
#define FACET_COMPILER \"${COMPILER}\"
#define FACET_BUILD_TYPE \"${BUILD_TYPE}\"
#define FACET_FLAGS \"${FLAGS}\"
")
set(old "")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} old)
endif()
if(NOT old STREQUAL text)
  file(WRITE ${OUTPUT} "${text}")
endif()
