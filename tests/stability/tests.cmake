# The scenes are those of benchmarks/stability. Label `stability`: all tests of this room, the long ones too, as in
# `ctest --test-dir build -L stability`.
target_include_directories(test_stability PRIVATE ${PROJECT_SOURCE_DIR}/benchmarks)
foreach(test IN ITEMS stability stability_long)
    if(TEST ${test})
        set_property(TEST ${test} APPEND PROPERTY LABELS stability)
    endif()
endforeach()
