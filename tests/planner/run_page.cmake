# Runs the tests of the page in a browser from a copy, so that node_modules stays out of the source
# tree: -DSOURCE= -DWORK= -DNODE= -DNPM=, VASOROD_PLAN in the environment.
set(here ${WORK}/tests/planner/page)
file(MAKE_DIRECTORY ${here})
file(COPY ${SOURCE}/tests/planner/page/ DESTINATION ${here} PATTERN node_modules EXCLUDE)
foreach(folder benchmarks meshes)
  file(CREATE_LINK ${SOURCE}/${folder} ${WORK}/${folder} SYMBOLIC)
endforeach()
execute_process(COMMAND ${NPM} ci --no-audit --no-fund WORKING_DIRECTORY ${here}
  RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(failed)
  message(FATAL_ERROR "npm ci cannot install what the page's tests need:\n${said}")
endif()
execute_process(COMMAND ${NODE} --test run.mjs WORKING_DIRECTORY ${here} RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "a test of the page failed")
endif()
