# A program with a preset of the library: it must not compile the scene itself, so it does not link without the library,
# and runs with it. LIBRARY: the one that add_subdirectory/ was built with. THREADS: the compiler's option for OpenMP,
# which both have or neither.
include(${CMAKE_CURRENT_LIST_DIR}/compile.cmake)
compile(${THREADS} -DIMBIBE_COMPILED_PRESETS -I${INCLUDE} ${EIGEN} -c ${CMAKE_CURRENT_LIST_DIR}/presets/main.cpp
        -o ${FOLDER}/main.o)
execute_process(COMMAND ${COMPILER} ${FLAGS} ${THREADS} ${FOLDER}/main.o -o ${FOLDER}/alone RESULT_VARIABLE result ERROR_VARIABLE errors)
if(result EQUAL 0 OR NOT errors MATCHES "Solver.*(take|prepare)")
    message(FATAL_ERROR "without the library the program should lack the functions of the scene: ${result}\n${errors}")
endif()
compile(${THREADS} ${FOLDER}/main.o ${LIBRARY} -o ${FOLDER}/program)
run(${FOLDER}/program)
