# Installs imbibe into an empty PREFIX and checks that what it left there does not point back to where it was built.
file(REMOVE_RECURSE ${PREFIX})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX} COMMAND_ERROR_IS_FATAL ANY)

file(GLOB_RECURSE headers RELATIVE ${SOURCE}/include ${SOURCE}/include/*.hpp)
foreach(header IN LISTS headers)
    if(NOT EXISTS ${PREFIX}/include/${header})
        message(SEND_ERROR "${header} was not installed")
    endif()
endforeach()

file(GLOB scripts ${PREFIX}/share/cmake/imbibe/*.cmake)
foreach(script IN LISTS scripts)
    file(READ ${script} text)
    string(FIND "${text}" "${SOURCE}" position)
    if(NOT position EQUAL -1)
        message(SEND_ERROR "${script} names the folder imbibe was installed from, ${SOURCE}")
    endif()
endforeach()
