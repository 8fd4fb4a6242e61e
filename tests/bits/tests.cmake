# Does a change leave every bit as it was? Compiled for one processor and without fused multiply-adds where the source has
# none, so that neither the machine nor what the compiler makes of two expressions decides; expected.txt is of g++, whose
# order of evaluation it has. After a change that is to change bits:
#
#   cmake --build build --target test_bits_more && build/tests/test_bits_more > tests/bits/expected.txt
include(CheckCXXCompilerFlag)
check_cxx_compiler_flag(-march=haswell imbibe_march_haswell)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND imbibe_march_haswell)
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/bits/*.cpp)
    add_executable(test_bits_more ${sources})
    target_link_libraries(test_bits_more PRIVATE imbibe)
    target_include_directories(test_bits_more PRIVATE ${PROJECT_SOURCE_DIR})
    target_compile_options(test_bits_more PRIVATE -march=haswell -ffp-contract=off $<$<CONFIG:Release>:-O1>)
    set_target_properties(test_bits_more PROPERTIES UNITY_BUILD OFF)
    add_test(NAME bits COMMAND test_bits_more ${CMAKE_CURRENT_SOURCE_DIR}/bits/expected.txt)
    set_tests_properties(bits PROPERTIES LABELS more TIMEOUT 600)
endif()
