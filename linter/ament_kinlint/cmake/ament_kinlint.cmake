# Add a test that checks the robot descriptions of a package with kinlint.
#
# ament_kinlint([TESTNAME <name>] [MAX_SEVERITY error|warning|info|none] [<path> ...])
#
# TESTNAME: name of the test, "kinlint" by default.
# MAX_SEVERITY: the least severity that fails the test, "warning" by default.
# Paths are files or directories; the directory of the package by default.
function(ament_kinlint)
  cmake_parse_arguments(ARG "" "TESTNAME;MAX_SEVERITY" "" ${ARGN})
  if(NOT ARG_TESTNAME)
    set(ARG_TESTNAME "kinlint")
  endif()
  find_program(ament_kinlint_BIN NAMES "ament_kinlint")
  if(NOT ament_kinlint_BIN)
    message(FATAL_ERROR "ament_kinlint() could not find the program 'ament_kinlint'")
  endif()
  set(result_file "${AMENT_TEST_RESULTS_DIR}/${PROJECT_NAME}/${ARG_TESTNAME}.xunit.xml")
  set(command "${ament_kinlint_BIN}" "--xunit-file" "${result_file}")
  if(ARG_MAX_SEVERITY)
    list(APPEND command "--fail-on" "${ARG_MAX_SEVERITY}")
  endif()
  list(APPEND command ${ARG_UNPARSED_ARGUMENTS})
  file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/ament_kinlint")
  ament_add_test(
    "${ARG_TESTNAME}"
    COMMAND ${command}
    TIMEOUT 120
    OUTPUT_FILE "${CMAKE_BINARY_DIR}/ament_kinlint/${ARG_TESTNAME}.txt"
    RESULT_FILE "${result_file}"
    WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}"
  )
  set_tests_properties("${ARG_TESTNAME}" PROPERTIES LABELS "kinlint;linter")
endfunction()
