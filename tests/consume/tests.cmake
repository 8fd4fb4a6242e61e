# Every way to take imbibe into another project: installed and found, as a subdirectory, fetched from a local folder,
# with a plain -I, through pkg-config, from a Debian package; and into projects with options of their own. Each is a
# small project or program beside this file, built and run as its user would.
set(prefix ${PROJECT_BINARY_DIR}/consume/prefix)

add_test(NAME consume_install
    COMMAND ${CMAKE_COMMAND} -DBUILD=${PROJECT_BINARY_DIR} -DSOURCE=${PROJECT_SOURCE_DIR} -DPREFIX=${prefix}
            -P ${CMAKE_CURRENT_LIST_DIR}/install.cmake)
set_tests_properties(consume_install PROPERTIES LABELS unit FIXTURES_SETUP imbibe_installed)

foreach(way find_package add_subdirectory fetch_content presets)
    add_test(NAME consume_${way}
        COMMAND ${CMAKE_CTEST_COMMAND}
            --build-and-test ${CMAKE_CURRENT_LIST_DIR}/${way} ${PROJECT_BINARY_DIR}/consume/${way}
            --build-generator ${CMAKE_GENERATOR} --build-noclean
            --build-options -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} "-DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS}"
                            -DCMAKE_PREFIX_PATH=${prefix} -DEigen3_DIR=${Eigen3_DIR}
                            -DIMBIBE_SOURCE=${PROJECT_SOURCE_DIR} -DEXPECTED_VERSION=${PROJECT_VERSION}
                            -DCMAKE_COMPILE_WARNING_AS_ERROR=${IMBIBE_STRICT} -DIMBIBE_OPENMP=${IMBIBE_OPENMP}
            --test-command program)
    set_tests_properties(consume_${way} PROPERTIES LABELS unit TIMEOUT 900)
endforeach()
set_tests_properties(consume_find_package PROPERTIES FIXTURES_REQUIRED imbibe_installed)
# All presets together compile for minutes: no ordinary test.
set_tests_properties(consume_presets PROPERTIES LABELS more FIXTURES_SETUP imbibe_presets_built)

# Without CMake: single calls of the compiler. See the script of each.
get_target_property(eigen_folders Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
set(threads "")
if(IMBIBE_OPENMP AND OpenMP_CXX_FOUND)
    set(threads ${OpenMP_CXX_FLAGS})
endif()
set(fast "-O3 ${threads}")
if(imbibe_march_native)
    string(APPEND fast " -march=native")
endif()
find_program(IMBIBE_PKG_CONFIG pkg-config REQUIRED)
find_program(IMBIBE_DPKG_DEB dpkg-deb)
find_program(IMBIBE_LINTIAN lintian) # where there is one, it looks at the package
function(add_way name script)
    add_test(NAME consume_${name}
        COMMAND ${CMAKE_COMMAND} -DCOMPILER=${CMAKE_CXX_COMPILER} -DCOMPILER_ID=${CMAKE_CXX_COMPILER_ID}
                "-DFLAGS=${CMAKE_CXX_FLAGS}" -DWARNINGS_ARE_ERRORS=${IMBIBE_STRICT}
                -DINCLUDE=${PROJECT_SOURCE_DIR}/include "-DEIGEN=${eigen_folders}"
                -DFOLDER=${PROJECT_BINARY_DIR}/consume/${name} -DVERSION=${PROJECT_VERSION} ${ARGN}
                -P ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/${script}.cmake)
    set_tests_properties(consume_${name} PROPERTIES LABELS unit TIMEOUT 900)
endfunction()
add_way(plain plain)
add_way(strict strict)
if(CMAKE_CXX_COMPILER_ID STREQUAL Clang)
    include(CheckCXXSourceCompiles)
    set(CMAKE_REQUIRED_FLAGS -stdlib=libc++)
    check_cxx_source_compiles("#include <string>\nint main() { return std::string(1, 'a').size() - 1; }" IMBIBE_HAS_LIBCXX)
    unset(CMAKE_REQUIRED_FLAGS)
    if(IMBIBE_HAS_LIBCXX)
        add_way(libcxx libcxx -DGUIDES=${PROJECT_SOURCE_DIR}/examples/guides)
    else()
        message(STATUS "Without libc++ there is no test of programs that use it")
    endif()
endif()
set(built ${PROJECT_BINARY_DIR}/consume/presets/imbibe)
add_way(compiled_scene compiled_scene -DPRESETS=${built}/libimbibe_presets.a -DCORE=${built}/libimbibe_core.a
        -DTHREADS=${threads})
set_tests_properties(consume_compiled_scene PROPERTIES LABELS more FIXTURES_REQUIRED imbibe_presets_built)
add_way(two_options two_options "-DFAST=${fast}")
set_tests_properties(consume_two_options PROPERTIES ENVIRONMENT "OMP_NUM_THREADS=2;OMP_WAIT_POLICY=passive")
add_way(pkg_config installed -DPREFIX=${prefix} -DPKG_CONFIG=${IMBIBE_PKG_CONFIG})
set_tests_properties(consume_pkg_config PROPERTIES FIXTURES_REQUIRED imbibe_installed)
add_way(folders folders -DGENERATOR=${CMAKE_GENERATOR} -DPKG_CONFIG=${IMBIBE_PKG_CONFIG} -DEIGEN_PACKAGE=${Eigen3_DIR})
if(IMBIBE_DPKG_DEB)
    add_way(package installed -DPACKAGE_OF=${PROJECT_BINARY_DIR} -DCPACK=${CMAKE_CPACK_COMMAND}
            -DDPKG_DEB=${IMBIBE_DPKG_DEB} "-DLINTIAN=$<$<BOOL:${IMBIBE_LINTIAN}>:${IMBIBE_LINTIAN}>"
            -DPKG_CONFIG=${IMBIBE_PKG_CONFIG})
else()
    message(STATUS "Without dpkg-deb there is no test of the Debian package")
endif()

add_test(NAME consume_version
    COMMAND ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR} -DVERSION=${PROJECT_VERSION}
            -P ${CMAKE_CURRENT_LIST_DIR}/version.cmake)
set_tests_properties(consume_version PROPERTIES LABELS unit)
