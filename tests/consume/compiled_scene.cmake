# Programs that do not compile their scene: one with presets of the library, one whose own scene another of its files
# compiles; and one that compiles its scene but not what knows no type of it. None links without what has the rest, and
# all run with it. PRESETS, CORE: the libraries of presets/ and of src/. THREADS: the compiler's option for OpenMP, which
# all have or none.
include(${CMAKE_CURRENT_LIST_DIR}/compile.cmake)

# check_without(<object of the program> <a function that it lacks> <what has it>...)
function(check_without object lacking)
    execute_process(COMMAND ${COMPILER} ${FLAGS} ${THREADS} ${object} -o ${FOLDER}/alone
        RESULT_VARIABLE result ERROR_VARIABLE errors)
    if(result EQUAL 0 OR NOT errors MATCHES ${lacking})
        message(FATAL_ERROR "without ${ARGN} the program should lack ${lacking}: ${result}\n${errors}")
    endif()
    compile(${THREADS} ${object} ${ARGN} -o ${FOLDER}/program)
    run(${FOLDER}/program)
endfunction()

compile(${THREADS} -DIMBIBE_COMPILED_PRESETS -DIMBIBE_COMPILED_CORE -I${INCLUDE} ${EIGEN}
        -c ${CMAKE_CURRENT_LIST_DIR}/presets/main.cpp -o ${FOLDER}/main.o)
check_without(${FOLDER}/main.o "Solver.*::add" ${PRESETS} ${CORE})

set(small ${CMAKE_CURRENT_LIST_DIR}/small)
foreach(file IN ITEMS main compiled_scene)
    compile(${THREADS} -include ${small}/compiled_scene.hpp -I${INCLUDE} ${EIGEN} -c ${small}/${file}.cpp
            -o ${FOLDER}/small_${file}.o)
endforeach()
check_without(${FOLDER}/small_main.o "Solver.*::add" ${FOLDER}/small_compiled_scene.o)

compile(${THREADS} -DIMBIBE_COMPILED_CORE -I${INCLUDE} ${EIGEN} -c ${small}/main.cpp -o ${FOLDER}/small_on_core.o)
check_without(${FOLDER}/small_on_core.o "SceneEngine.*::run" ${CORE})

