# Installs the headers and the package that find_package(imbibe) reads.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_DATADIR}/cmake/imbibe)
install(TARGETS imbibe EXPORT imbibe-targets FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT imbibe-targets NAMESPACE imbibe:: DESTINATION ${package_folder})

# Before 1.0 a new minor version may change names, so 0.1 does not pass for 0.2.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/imbibe-config-version.cmake
    COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${CMAKE_CURRENT_LIST_DIR}/imbibe-config.cmake ${PROJECT_BINARY_DIR}/imbibe-config-version.cmake
    DESTINATION ${package_folder})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
