# With libc++, clang's own standard library, which is that of macOS and FreeBSD: programs that write, read back and restart.
include(${CMAKE_CURRENT_LIST_DIR}/compile.cmake)
foreach(program stop_and_restart own_study)
    compile(-O1 -stdlib=libc++ -I${INCLUDE} ${EIGEN} ${GUIDES}/${program}.cpp -o ${FOLDER}/${program})
    run(${CMAKE_COMMAND} -E chdir ${FOLDER} ./${program})
endforeach()
