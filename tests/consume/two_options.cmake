# Two parts of a program, compiled with different options: each must do to the last bit what it does when it is alone,
# in whichever order they are linked.
include(${CMAKE_CURRENT_LIST_DIR}/compile.cmake)
separate_arguments(FAST UNIX_COMMAND "${FAST}")
set(from ${CMAKE_CURRENT_LIST_DIR}/two_options)

# check_parts(<folder> <options of the part plain> <options of the part fast>), each a list
function(check_parts folder plain_options fast_options)
    file(MAKE_DIRECTORY ${folder})
    compile(${plain_options} -I${INCLUDE} ${EIGEN} -DPART=plain -c ${from}/part.cpp -o ${folder}/plain.o)
    compile(${fast_options} -I${INCLUDE} ${EIGEN} -DPART=fast -c ${from}/part.cpp -o ${folder}/fast.o)

    foreach(parts IN ITEMS plain fast "plain fast" "fast plain")
        separate_arguments(part_list UNIX_COMMAND "${parts}")
        list(TRANSFORM part_list PREPEND -DWITH_ OUTPUT_VARIABLE definitions)
        list(TRANSFORM part_list REPLACE "(.+)" "${folder}/\\1.o" OUTPUT_VARIABLE objects)
        string(REPLACE " " "_" name ${parts})
        compile(${fast_options} ${definitions} ${from}/main.cpp ${objects} -o ${folder}/${name})
        run(${folder}/${name})
        set(${name} "${output}")
    endforeach()
    foreach(together IN ITEMS "${plain_fast}" "${fast_plain}")
        if(NOT together STREQUAL "${plain}${fast}")
            message(FATAL_ERROR "alone the parts print\n${plain}${fast}together\n${together}")
        endif()
    endforeach()
    string(REGEX REPLACE "^[a-z]+: " "" plain_result "${plain}")
    string(REGEX REPLACE "^[a-z]+: " "" fast_result "${fast}")
    if(plain_result STREQUAL fast_result)
        message(FATAL_ERROR "the options make no difference, so nothing was tested: ${plain}${fast}")
    endif()
endfunction()

# Without optimisation and OpenMP, and with all of it (FAST).
check_parts(${FOLDER}/all -O0 "${FAST}")
# Two instruction sets whose packs are equally wide, where FAST, which is for this processor, has both.
execute_process(COMMAND ${COMPILER} ${FAST} -x c++ -dM -E ${from}/main.cpp OUTPUT_VARIABLE macros
    COMMAND_ERROR_IS_FATAL ANY)
if(macros MATCHES "__AVX2__" AND macros MATCHES "__FMA__")
    set(fused -O2 -ffp-contract=fast)
    check_parts(${FOLDER}/instructions "${fused};-mavx" "${fused};-mavx2;-mfma")
endif()
