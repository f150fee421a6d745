# cmake --install: the library for programs that embed it (component `library`: headers, archive or shared library, CMake
# package, pkg-config file; needs the standard library alone) and the command (component `command`, see apps/).

include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/waybreaker)

install(TARGETS waybreaker EXPORT waybreaker
        LIBRARY COMPONENT library NAMELINK_COMPONENT library
        ARCHIVE COMPONENT library
        RUNTIME COMPONENT library)
install(DIRECTORY include/waybreaker DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT library)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT library)

# The package has no dependencies to look for, so that the exported targets are all of it.
install(EXPORT waybreaker NAMESPACE waybreaker:: FILE waybreaker-config.cmake DESTINATION ${package_dir} COMPONENT library)
write_basic_package_version_file(waybreaker-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/waybreaker-config-version.cmake DESTINATION ${package_dir} COMPONENT library)

# From where it lies, so that the installed tree can be moved.
file(RELATIVE_PATH prefix_of_pc /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" prefix_of_pc ${prefix_of_pc})
configure_file(${CMAKE_CURRENT_LIST_DIR}/waybreaker.pc.in waybreaker.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/waybreaker.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT library)
