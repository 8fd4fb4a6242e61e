# One call of the compiler with -I, without CMake and without OpenMP; the same without run-time type information, and in
# a host that has changed the order of Eigen's matrices.
include(${CMAKE_CURRENT_LIST_DIR}/compile.cmake)
compile(-I${INCLUDE} ${EIGEN} ${CMAKE_CURRENT_LIST_DIR}/small/main.cpp -o ${FOLDER}/plain)
run(${FOLDER}/plain)
compile(-fno-rtti -I${INCLUDE} ${EIGEN} ${CMAKE_CURRENT_LIST_DIR}/small/no_rtti.cpp -o ${FOLDER}/no_rtti)
run(${FOLDER}/no_rtti)
compile(-DEIGEN_DEFAULT_TO_ROW_MAJOR -I${INCLUDE} ${EIGEN} ${CMAKE_CURRENT_LIST_DIR}/small/row_major.cpp
        -o ${FOLDER}/row_major)
run(${FOLDER}/row_major)
