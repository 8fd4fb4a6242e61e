# The scenes are those of benchmarks/stability.
foreach(test IN ITEMS stability stability_more stability_long)
    target_include_directories(test_${test} PRIVATE ${PROJECT_SOURCE_DIR}/benchmarks)
endforeach()
# The test of all limits runs the rows of the table.
target_sources(test_stability_more PRIVATE ${PROJECT_SOURCE_DIR}/benchmarks/stability/limit_rows.cpp)
