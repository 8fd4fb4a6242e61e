# Installs the headers and the package that find_package(imbibe) reads.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS imbibe EXPORT imbibe-targets FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT imbibe-targets NAMESPACE imbibe:: DESTINATION ${CMAKE_INSTALL_DATADIR}/cmake/imbibe)

file(WRITE ${PROJECT_BINARY_DIR}/imbibe-config.cmake [[
include(CMakeFindDependencyMacro)
find_dependency(Eigen3 3.3 NO_MODULE)
find_dependency(OpenMP COMPONENTS CXX)
include(${CMAKE_CURRENT_LIST_DIR}/imbibe-targets.cmake)
]])
if(NOT OpenMP_CXX_FOUND)
    file(READ ${PROJECT_BINARY_DIR}/imbibe-config.cmake config)
    string(REPLACE "find_dependency(OpenMP COMPONENTS CXX)\n" "" config "${config}")
    file(WRITE ${PROJECT_BINARY_DIR}/imbibe-config.cmake "${config}")
endif()
write_basic_package_version_file(${PROJECT_BINARY_DIR}/imbibe-config-version.cmake
    COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${PROJECT_BINARY_DIR}/imbibe-config.cmake ${PROJECT_BINARY_DIR}/imbibe-config-version.cmake
    DESTINATION ${CMAKE_INSTALL_DATADIR}/cmake/imbibe)
