# Checks that what the pages show is what is compiled, and that their links lead somewhere.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME pages COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/docs/site/check_pages.py)
set_tests_properties(pages PROPERTIES LABELS unit)

# Runs the programs of docs/guides.md; each checks its own physics. Their scenes are small: threads that keep a core busy
# while they wait can make them a hundred times slower on a machine that has other work.
file(GLOB guides CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/examples/guides/*.cpp)
foreach(file IN LISTS guides)
    get_filename_component(name ${file} NAME_WE)
    if(TARGET guide_${name})
        add_test(NAME guide_${name} COMMAND guide_${name} WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
        set_tests_properties(guide_${name} PROPERTIES LABELS more TIMEOUT 300 ENVIRONMENT OMP_WAIT_POLICY=passive)
    endif()
endforeach()

# Runs those of docs/first_hour.md with coarse particles; a Guard ends a run whose water leaks, is too dense, or gains
# energy from nowhere.
file(GLOB programs CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/examples/first_hour/*.cpp)
foreach(file IN LISTS programs)
    get_filename_component(name ${file} NAME_WE)
    if(TARGET first_hour_${name})
        add_test(NAME first_hour_${name} COMMAND first_hour_${name} 0.02 WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
        set_tests_properties(first_hour_${name} PROPERTIES LABELS more TIMEOUT 300 ENVIRONMENT OMP_WAIT_POLICY=passive)
    endif()
endforeach()
