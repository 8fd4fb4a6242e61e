# The scenes are those of benchmarks/stability. Labels: `stability`, all hard cases, as in
# `ctest --test-dir build -L stability`; those in brief/ are ordinary tests as well, those in long/ also `validation`.
add_room(stability_brief stability/brief)
add_test(NAME stability_brief COMMAND test_stability_brief)
set_tests_properties(stability_brief PROPERTIES LABELS unit TIMEOUT ${IMBIBE_TEST_TIMEOUT})
set_tests_properties(stability PROPERTIES LABELS stability COST 900)
set_property(TEST stability_long APPEND PROPERTY LABELS stability)
foreach(test IN ITEMS stability stability_brief stability_long)
    target_include_directories(test_${test} PRIVATE ${PROJECT_SOURCE_DIR}/benchmarks)
endforeach()
# Its test of all limits runs the rows of the table.
target_sources(test_stability PRIVATE ${PROJECT_SOURCE_DIR}/benchmarks/stability/limit_rows.cpp)
