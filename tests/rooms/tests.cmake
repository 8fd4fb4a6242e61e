# No folder of the library includes one above it.
add_test(NAME rooms COMMAND python3 ${CMAKE_CURRENT_SOURCE_DIR}/rooms/check_rooms.py)
set_tests_properties(rooms PROPERTIES LABELS unit)
