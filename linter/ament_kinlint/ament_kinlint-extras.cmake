find_package(ament_cmake_test QUIET REQUIRED)
include("${ament_kinlint_DIR}/ament_kinlint.cmake")
ament_register_extension("ament_lint_auto" "ament_kinlint" "ament_kinlint_lint_hook.cmake")
