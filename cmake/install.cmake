# Installs the headers, the package that find_package(imbibe) reads, and what pkg-config reads.
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
# For imbibe.pc. A folder that the compiler searches anyway must not be given once more: its order would change.
get_target_property(eigen_folder Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
if(eigen_folder MATCHES "/eigen3$")
    set(eigen_as_system " -isystem ${eigen_folder}")
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/imbibe.pc.in ${PROJECT_BINARY_DIR}/imbibe.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/imbibe.pc DESTINATION ${CMAKE_INSTALL_DATADIR}/pkgconfig)

# `cd build && cpack` makes a Debian package of the same files.
if(PROJECT_IS_TOP_LEVEL)
    set(CPACK_GENERATOR DEB)
    set(CPACK_PACKAGE_NAME libimbibe-dev)
    set(CPACK_PACKAGE_CONTACT "The imbibe authors")
    set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
    set(CPACK_VERBATIM_VARIABLES ON)
    set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
    set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE all)
    set(CPACK_DEBIAN_PACKAGE_SECTION libdevel)
    set(CPACK_DEBIAN_PACKAGE_DEPENDS libeigen3-dev)
    include(CPack)
endif()
