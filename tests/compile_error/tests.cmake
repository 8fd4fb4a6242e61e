# What must not compile: each program beside this file breaks one rule of a scene, and the compiler must say so in one
# error that names the rule and the culprits. What is expected stands in the program's first lines.
file(GLOB programs CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*.cpp)
get_target_property(eigen_folders Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
function(add_compile_error name)
    add_test(NAME compile_error_${name}
        COMMAND ${CMAKE_COMMAND} -DCOMPILER=${CMAKE_CXX_COMPILER} -DCOMPILER_ID=${CMAKE_CXX_COMPILER_ID}
                "-DFLAGS=${CMAKE_CXX_FLAGS}" -DINCLUDE=${PROJECT_SOURCE_DIR}/include "-DEIGEN=${eigen_folders}"
                -DHEADER=${PROJECT_BINARY_DIR}/compile_error/scene ${ARGN}
                -P ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/check.cmake)
    set_tests_properties(compile_error_${name} PROPERTIES LABELS unit TIMEOUT 300)
endfunction()

add_compile_error(header)
set_tests_properties(compile_error_header PROPERTIES FIXTURES_SETUP imbibe_scene_precompiled)
foreach(program IN LISTS programs)
    get_filename_component(name ${program} NAME_WE)
    add_compile_error(${name} -DPROGRAM=${program})
    set_tests_properties(compile_error_${name} PROPERTIES FIXTURES_REQUIRED imbibe_scene_precompiled)
endforeach()
