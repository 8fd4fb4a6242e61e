# The scenes are those of benchmarks/stability. Label `stability`: all tests of this room, the long ones too, as in
# `ctest --test-dir build -L stability`.
foreach(test IN ITEMS stability stability_long)
    target_include_directories(test_${test} PRIVATE ${PROJECT_SOURCE_DIR}/benchmarks)
    set_property(TEST ${test} APPEND PROPERTY LABELS stability)
endforeach()
# Its test of all limits runs the rows of the table.
target_sources(test_stability PRIVATE ${PROJECT_SOURCE_DIR}/benchmarks/stability/limit_rows.cpp)
