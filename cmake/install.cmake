# Installs the headers, the package that find_package(imbibe) reads, and what pkg-config reads.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_DATADIR}/cmake/imbibe)
install(TARGETS imbibe EXPORT imbibe-targets FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT imbibe-targets NAMESPACE imbibe:: DESTINATION ${package_folder})
# A library of the project around this one that hands on imbibe::imbibe is exported from its build folder only if this
# is, too.
export(EXPORT imbibe-targets NAMESPACE imbibe:: FILE ${PROJECT_BINARY_DIR}/imbibe-targets.cmake)

# Before 1.0 a new minor version may change names, so 0.1 does not pass for 0.2.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/imbibe-config-version.cmake
    COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${CMAKE_CURRENT_LIST_DIR}/imbibe-config.cmake ${PROJECT_BINARY_DIR}/imbibe-config-version.cmake
    DESTINATION ${package_folder})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT licence)
# For imbibe.pc. A folder that the compiler searches anyway must not be given once more: its order would change.
get_target_property(eigen_folder Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
if(eigen_folder MATCHES "/eigen3$")
    set(eigen_as_system " -isystem ${eigen_folder}")
endif()
if(IS_ABSOLUTE "${CMAKE_INSTALL_INCLUDEDIR}")
    set(include_folder ${CMAKE_INSTALL_FULL_INCLUDEDIR})
else()
    set(include_folder "\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}")
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/imbibe.pc.in ${PROJECT_BINARY_DIR}/imbibe.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/imbibe.pc DESTINATION ${CMAKE_INSTALL_DATADIR}/pkgconfig)

# `cd build && cpack` makes a Debian package of the same files, with what Debian wants to see of licence and changes.
if(PROJECT_IS_TOP_LEVEL)
    set(CPACK_GENERATOR DEB)
    set(CPACK_PACKAGE_NAME libimbibe-dev)
    set(CPACK_PACKAGE_CONTACT "The imbibe authors <noreply@imbibe.example>")
    set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "smoothed particle hydrodynamics (headers)")
    set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
    set(CPACK_VERBATIM_VARIABLES ON)
    set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
    set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE all)
    set(CPACK_DEBIAN_PACKAGE_SECTION libdevel)
    set(CPACK_DEBIAN_PACKAGE_DEPENDS libeigen3-dev)
    set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"A C++20 library for water, elastic solids, and how they push on each other.
A scene is a type that lists its physical effects, and an effect that is not
in the list costs no memory and no time.")

    set(debian_folder ${PROJECT_BINARY_DIR}/debian)
    string(TIMESTAMP debian_date "%a, %d %b %Y %H:%M:%S +0000" UTC)
    file(WRITE ${debian_folder}/changelog "imbibe (${PROJECT_VERSION}) unstable; urgency=medium

  * Version ${PROJECT_VERSION}; what is new in it is in CHANGELOG.md of the source.

 -- ${CPACK_PACKAGE_CONTACT}  ${debian_date}
")
    file(ARCHIVE_CREATE OUTPUT ${debian_folder}/changelog.gz PATHS ${debian_folder}/changelog
        FORMAT raw COMPRESSION GZip COMPRESSION_LEVEL 9)
    set(debian_documents ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_PACKAGE_NAME})
    install(FILES ${debian_folder}/changelog.gz DESTINATION ${debian_documents} COMPONENT debian EXCLUDE_FROM_ALL)
    install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${debian_documents} RENAME copyright
        COMPONENT debian EXCLUDE_FROM_ALL)
    # Debian's place for the licence instead of that of `cmake --install`.
    set(CPACK_INSTALL_CMAKE_PROJECTS ${PROJECT_BINARY_DIR} ${PROJECT_NAME} Unspecified /
                                     ${PROJECT_BINARY_DIR} ${PROJECT_NAME} debian /)
    include(CPack)
endif()
