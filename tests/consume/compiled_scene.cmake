# Programs that do not compile their scene: one with presets of the library, one whose own scene another of its files
# compiles. Neither links without what has the scene, and both run with it. LIBRARY: the one that presets/ was
# built with. THREADS: the compiler's option for OpenMP, which both have or neither.
include(${CMAKE_CURRENT_LIST_DIR}/compile.cmake)

# check_without_scene(<object of the program> <what has the scene>)
function(check_without_scene object scene)
    execute_process(COMMAND ${COMPILER} ${FLAGS} ${THREADS} ${object} -o ${FOLDER}/alone
        RESULT_VARIABLE result ERROR_VARIABLE errors)
    if(result EQUAL 0 OR NOT errors MATCHES "Solver.*::add")
        message(FATAL_ERROR "without ${scene} the program should lack the functions of the scene: ${result}\n${errors}")
    endif()
    compile(${THREADS} ${object} ${scene} -o ${FOLDER}/program)
    run(${FOLDER}/program)
endfunction()

compile(${THREADS} -DIMBIBE_COMPILED_PRESETS -I${INCLUDE} ${EIGEN} -c ${CMAKE_CURRENT_LIST_DIR}/presets/main.cpp
        -o ${FOLDER}/main.o)
check_without_scene(${FOLDER}/main.o ${LIBRARY})

set(small ${CMAKE_CURRENT_LIST_DIR}/small)
foreach(file IN ITEMS main compiled_scene)
    compile(${THREADS} -include ${small}/compiled_scene.hpp -I${INCLUDE} ${EIGEN} -c ${small}/${file}.cpp
            -o ${FOLDER}/small_${file}.o)
endforeach()
check_without_scene(${FOLDER}/small_main.o ${FOLDER}/small_compiled_scene.o)
