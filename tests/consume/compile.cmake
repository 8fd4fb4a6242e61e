# For the ways to use imbibe without CMake: compiles and runs programs by single calls of the compiler.
# Set from outside: COMPILER, FLAGS (the build's own, as one string), EIGEN (a folder), INCLUDE, FOLDER (for what is made).
separate_arguments(FLAGS UNIX_COMMAND "${FLAGS}")
if(WARNINGS_ARE_ERRORS)
    list(APPEND FLAGS -Werror)
endif()
list(TRANSFORM EIGEN PREPEND -isystem)
file(MAKE_DIRECTORY ${FOLDER})

# run(<command>...): its output is in `output`; ends the test where it fails.
function(run)
    execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE errors RESULT_VARIABLE result)
    if(NOT result EQUAL 0)
        list(JOIN ARGN " " command)
        message(FATAL_ERROR "failed (${result}): ${command}\n${output}${errors}")
    endif()
    message("${output}${errors}")
    set(output "${output}" PARENT_SCOPE)
endfunction()

# compile(<arguments>...)
function(compile)
    run(${COMPILER} ${FLAGS} -std=c++20 ${ARGN})
endfunction()
