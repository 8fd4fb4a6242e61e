# Every way to take imbibe into another project: installed and found, as a subdirectory, fetched from a local folder.
# Each is a small project beside this file, configured, built and run as its user would.
set(prefix ${PROJECT_BINARY_DIR}/consume/prefix)

add_test(NAME consume_install
    COMMAND ${CMAKE_COMMAND} -DBUILD=${PROJECT_BINARY_DIR} -DSOURCE=${PROJECT_SOURCE_DIR} -DPREFIX=${prefix}
            -P ${CMAKE_CURRENT_LIST_DIR}/install.cmake)
set_tests_properties(consume_install PROPERTIES LABELS unit FIXTURES_SETUP imbibe_installed)

foreach(way find_package add_subdirectory fetch_content)
    add_test(NAME consume_${way}
        COMMAND ${CMAKE_CTEST_COMMAND}
            --build-and-test ${CMAKE_CURRENT_LIST_DIR}/${way} ${PROJECT_BINARY_DIR}/consume/${way}
            --build-generator ${CMAKE_GENERATOR} --build-noclean
            --build-options -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} "-DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS}"
                            -DCMAKE_PREFIX_PATH=${prefix} -DEigen3_DIR=${Eigen3_DIR}
                            -DIMBIBE_SOURCE=${PROJECT_SOURCE_DIR} -DEXPECTED_VERSION=${PROJECT_VERSION}
                            -DCMAKE_COMPILE_WARNING_AS_ERROR=${IMBIBE_STRICT}
            --test-command program)
    set_tests_properties(consume_${way} PROPERTIES LABELS unit TIMEOUT 900)
endforeach()
set_tests_properties(consume_find_package PROPERTIES FIXTURES_REQUIRED imbibe_installed)

if(EXISTS ${PROJECT_SOURCE_DIR}/examples/dam_break.cpp)
    add_test(NAME consume_readme
        COMMAND ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR} -P ${CMAKE_CURRENT_LIST_DIR}/readme.cmake)
    set_tests_properties(consume_readme PROPERTIES LABELS unit)
endif()
