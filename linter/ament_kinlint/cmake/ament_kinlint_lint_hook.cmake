# What ament_lint_auto_find_test_dependencies() adds: one test, if there is a robot description.
file(GLOB_RECURSE _kinlint_files FOLLOW_SYMLINKS
  "*.urdf" "*.xacro" "*.srdf" "*.sdf" "*.world" "*.jsonld")
if(_kinlint_files)
  message(STATUS "Added test 'kinlint' to check robot descriptions")
  ament_kinlint()
endif()
