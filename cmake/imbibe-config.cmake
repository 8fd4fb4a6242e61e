# What find_package(imbibe) reads once imbibe is installed: defines the target imbibe::imbibe.
# Whether there is OpenMP is asked of the compiler at hand, not of the one imbibe was installed with.
# Set IMBIBE_OPENMP to OFF beforehand to do without it.
foreach(component IN LISTS imbibe_FIND_COMPONENTS)
    if(imbibe_FIND_REQUIRED_${component})
        set(imbibe_FOUND FALSE)
        set(imbibe_NOT_FOUND_MESSAGE "imbibe has no component '${component}': it is one piece, without components")
        return()
    endif()
endforeach()

include(CMakeFindDependencyMacro)
find_dependency(Eigen3 NO_MODULE)
include(${CMAKE_CURRENT_LIST_DIR}/imbibe-targets.cmake)

if(NOT DEFINED IMBIBE_OPENMP OR IMBIBE_OPENMP)
    find_package(OpenMP QUIET COMPONENTS CXX)
    if(OpenMP_CXX_FOUND)
        target_link_libraries(imbibe::imbibe INTERFACE OpenMP::OpenMP_CXX)
    endif()
endif()
