# Checks that the dam break in the README is, to the letter, the example that is compiled. To copy the example there:
#   cmake -DSOURCE=. -DWRITE=ON -P tests/consume/readme.cmake
file(READ ${SOURCE}/README.md readme)
file(READ ${SOURCE}/examples/dam_break.cpp example)

string(REGEX MATCH "<!-- examples/dam_break.cpp: begin[^\n]*\n" begin "${readme}")
string(FIND "${readme}" "${begin}" start)
string(FIND "${readme}" "<!-- examples/dam_break.cpp: end" end)
if(begin STREQUAL "" OR end LESS start)
    message(FATAL_ERROR "README.md has lost the marks around the dam break")
endif()
string(LENGTH "${begin}" length)
math(EXPR start "${start} + ${length}")
math(EXPR length "${end} - ${start}")
string(SUBSTRING "${readme}" 0 ${start} before)
string(SUBSTRING "${readme}" ${start} ${length} shown)
string(SUBSTRING "${readme}" ${end} -1 after)

set(wanted "```cpp\n${example}```\n")
if(WRITE)
    file(WRITE ${SOURCE}/README.md "${before}${wanted}${after}")
elseif(NOT shown STREQUAL wanted)
    message(FATAL_ERROR "The dam break in README.md is not examples/dam_break.cpp; to copy it there:\n"
        "  cmake -DSOURCE=. -DWRITE=ON -P tests/consume/readme.cmake")
endif()
