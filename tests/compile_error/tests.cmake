# What must not compile: each program beside this file breaks one rule of a scene, and the compiler must say so in one
# error that names the rule and the culprits. What is expected stands in the program's first lines.
file(GLOB programs CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*.cpp)
get_target_property(eigen_folders Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
foreach(program IN LISTS programs)
    get_filename_component(name ${program} NAME_WE)
    add_test(NAME compile_error_${name}
        COMMAND ${CMAKE_COMMAND} -DCOMPILER=${CMAKE_CXX_COMPILER} "-DFLAGS=${CMAKE_CXX_FLAGS}" -DPROGRAM=${program}
                -DINCLUDE=${PROJECT_SOURCE_DIR}/include "-DEIGEN=${eigen_folders}"
                -P ${CMAKE_CURRENT_LIST_DIR}/check.cmake)
    set_tests_properties(compile_error_${name} PROPERTIES LABELS unit TIMEOUT 300)
endforeach()
