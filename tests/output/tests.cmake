# What the tests of this room write, VTK itself reads back: needs a Python with VTK (Debian: python3-vtk9).
# Another Python may stand before the system's in the search path, so each is asked; if none has VTK the test fails.
set(output_folder ${CMAKE_CURRENT_BINARY_DIR}/output_files)
target_compile_definitions(test_output PRIVATE
    IMBIBE_OUTPUT_TEST_FOLDER="${output_folder}" IMBIBE_TOOLS_DIR="${PROJECT_SOURCE_DIR}/tools")

set(python_with_vtk python3)
foreach(candidate IN ITEMS $ENV{IMBIBE_PYTHON} python3 /usr/bin/python3)
    execute_process(COMMAND ${candidate} -c "import vtkmodules, numpy" RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
    if(failed STREQUAL "0")
        set(python_with_vtk ${candidate})
        break()
    endif()
endforeach()

set_tests_properties(output PROPERTIES FIXTURES_SETUP output_files)
add_test(NAME output_read_vtk
    COMMAND ${python_with_vtk} ${CMAKE_CURRENT_SOURCE_DIR}/output/read_vtk.py ${output_folder})
add_test(NAME output_pictures
    COMMAND ${python_with_vtk} ${CMAKE_CURRENT_SOURCE_DIR}/output/draw_pictures.py ${output_folder})
set_tests_properties(output_read_vtk output_pictures PROPERTIES
    LABELS unit TIMEOUT 600 FIXTURES_REQUIRED output_files)
add_test(NAME output_pictures_of_space
    COMMAND ${python_with_vtk} ${CMAKE_CURRENT_SOURCE_DIR}/output/draw_space.py ${output_folder})
set_tests_properties(output_pictures_of_space PROPERTIES
    LABELS unit TIMEOUT 600 FIXTURES_REQUIRED output_files SKIP_RETURN_CODE 77)
# Skipped where there is no three.js (tools/install_packages.sh view) or no Chromium (browser).
add_test(NAME output_view_page
    COMMAND ${python_with_vtk} ${CMAKE_CURRENT_SOURCE_DIR}/output/view_page.py ${output_folder}_view)
set_tests_properties(output_view_page PROPERTIES LABELS unit TIMEOUT 900 SKIP_RETURN_CODE 77)

# The example itself, some steps of it; the small ones, each once; four kills and, which takes minutes, a hundred. Label
# `examples`: not in the default command, because the sponge takes a compiler long.
if(TARGET sponge)
    add_test(NAME run_sponge
        COMMAND ${python_with_vtk} ${CMAKE_CURRENT_SOURCE_DIR}/output/run_sponge.py $<TARGET_FILE:sponge>)
    set_tests_properties(run_sponge PROPERTIES LABELS examples TIMEOUT 1800)
    add_test(NAME run_examples
        COMMAND python3 ${CMAKE_CURRENT_SOURCE_DIR}/output/run_examples.py $<TARGET_FILE_DIR:sponge>)
    set_tests_properties(run_examples PROPERTIES LABELS examples TIMEOUT 1800)
    add_test(NAME kill_sponge_briefly
        COMMAND ${python_with_vtk} ${CMAKE_CURRENT_SOURCE_DIR}/output/long/kill_sponge.py $<TARGET_FILE:sponge>
            --kills 4 --case "sound, float")
    set_tests_properties(kill_sponge_briefly PROPERTIES LABELS examples TIMEOUT 1800)
    add_test(NAME kill_sponge
        COMMAND ${python_with_vtk} ${CMAKE_CURRENT_SOURCE_DIR}/output/long/kill_sponge.py $<TARGET_FILE:sponge>)
    set_tests_properties(kill_sponge PROPERTIES LABELS validation TIMEOUT 7200)
endif()
