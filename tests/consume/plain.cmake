# One call of the compiler with -I, without CMake and without OpenMP; and the same without run-time type information.
include(${CMAKE_CURRENT_LIST_DIR}/compile.cmake)
compile(-I${INCLUDE} ${EIGEN} ${CMAKE_CURRENT_LIST_DIR}/small/main.cpp -o ${FOLDER}/plain)
run(${FOLDER}/plain)
compile(-fno-rtti -I${INCLUDE} ${EIGEN} ${CMAKE_CURRENT_LIST_DIR}/small/no_rtti.cpp -o ${FOLDER}/no_rtti)
run(${FOLDER}/no_rtti)
