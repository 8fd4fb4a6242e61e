# Runs the programs of docs/guides.md; each checks its own physics.
file(GLOB guides CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/examples/guides/*.cpp)
foreach(file IN LISTS guides)
    get_filename_component(name ${file} NAME_WE)
    if(TARGET guide_${name})
        add_test(NAME guide_${name} COMMAND guide_${name} WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
        set_tests_properties(guide_${name} PROPERTIES LABELS unit TIMEOUT 300)
    endif()
endforeach()
