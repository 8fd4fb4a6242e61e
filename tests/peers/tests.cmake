# tools/compare_peers.py on made-up reports and logs.
add_test(NAME compare_peers COMMAND python3 ${CMAKE_CURRENT_SOURCE_DIR}/peers/compare_peers.py)
set_tests_properties(compare_peers PROPERTIES LABELS unit)
