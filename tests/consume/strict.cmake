# All headers with -I, not -isystem, under the strictest warnings of the compiler, as errors; then it is run.
#
# Off are only those that say nothing here: numbers are compared with exactly 0, or with the very number that was given
# before (float-equal); structs have gaps (padded); a header has nowhere else to put a class's virtual functions
# (weak-vtables); `default` is there for one of two values (switch-enum); C++20 is not C++98 (compat).
#
# What headers of common platforms define as macros (strict/platform_macros.hpp) are no names in the library.
include(${CMAKE_CURRENT_LIST_DIR}/compile.cmake)
if(COMPILER_ID STREQUAL Clang)
    set(warnings -Weverything -Wno-c++98-compat -Wno-c++98-compat-pedantic -Wno-c++20-compat -Wno-float-equal -Wno-padded
                 -Wno-weak-vtables -Wno-switch-enum)
else()
    set(warnings -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wold-style-cast -Wuseless-cast
                 -Wcast-qual -Wcast-align -Wdouble-promotion -Wnon-virtual-dtor -Woverloaded-virtual -Wduplicated-cond
                 -Wduplicated-branches -Wlogical-op -Wformat=2 -Wextra-semi -Wundef -Wredundant-decls)
endif()
compile(-O0 ${warnings} -Werror -I${INCLUDE} ${EIGEN} ${CMAKE_CURRENT_LIST_DIR}/strict/program.cpp
        -o ${FOLDER}/program)
run(${CMAKE_COMMAND} -E chdir ${FOLDER} ./program)
