# Projects that are configured and installed, and not compiled: one that exports a library which hands on imbibe::imbibe
# (exported/), and imbibe itself with headers in a folder that is not under its prefix, which pkg-config must name.
include(${CMAKE_CURRENT_LIST_DIR}/compile.cmake)
file(REMOVE_RECURSE ${FOLDER})
set(options -G "${GENERATOR}" -DCMAKE_CXX_COMPILER=${COMPILER} -DEigen3_DIR=${EIGEN_PACKAGE})
get_filename_component(source ${INCLUDE} DIRECTORY)

run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/exported -B ${FOLDER}/exported -DIMBIBE_SOURCE=${source} ${options})
run(${CMAKE_COMMAND} --install ${FOLDER}/exported --prefix ${FOLDER}/exported-prefix)
foreach(folder IN ITEMS exported exported-prefix/lib/cmake/flow)
    file(READ ${FOLDER}/${folder}/flow-targets.cmake text)
    if(NOT text MATCHES "imbibe::imbibe")
        message(FATAL_ERROR "${folder}/flow-targets.cmake does not say that flow needs imbibe::imbibe")
    endif()
endforeach()

set(elsewhere ${FOLDER}/elsewhere/headers)
run(${CMAKE_COMMAND} -S ${source} -B ${FOLDER}/build ${options} -DIMBIBE_TESTS=OFF -DIMBIBE_EXAMPLES=OFF
    -DCMAKE_INSTALL_PREFIX=${FOLDER}/prefix -DCMAKE_INSTALL_INCLUDEDIR=${elsewhere})
run(${CMAKE_COMMAND} --install ${FOLDER}/build)
set(ENV{PKG_CONFIG_PATH} ${FOLDER}/prefix/share/pkgconfig:$ENV{PKG_CONFIG_PATH})
run(${PKG_CONFIG} --variable=includedir imbibe)
string(STRIP "${output}" output)
if(NOT EXISTS ${output}/imbibe/imbibe.hpp)
    message(FATAL_ERROR "pkg-config names ${output}, and the headers are in ${elsewhere}")
endif()
