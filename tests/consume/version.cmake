# Whatever names the version of the library says what include/imbibe/version.hpp says, VERSION.
string(REGEX REPLACE "\\.[0-9]+$" "" minor ${VERSION})
foreach(place IN ITEMS "CITATION.cff;version: ${VERSION}\n" "CHANGELOG.md;## ${VERSION}"
                       "docs/your_project.md;find_package(imbibe ${minor} REQUIRED)")
    list(POP_FRONT place file words)
    file(READ ${SOURCE}/${file} text)
    string(FIND "${text}" "${words}" position)
    if(position EQUAL -1)
        message(SEND_ERROR "${file} does not say '${words}', the version of include/imbibe/version.hpp")
    endif()
endforeach()
