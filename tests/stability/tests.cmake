# The test of all limits runs the rows of the table; the scenes are those of cases/stability.
target_sources(test_stability_more PRIVATE ${PROJECT_SOURCE_DIR}/cases/stability/limit_rows.cpp)
