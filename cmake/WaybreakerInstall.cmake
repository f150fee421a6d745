# cmake --install: the libraries for programs that embed them, in C++ and, where the documents are built, in C (component
# `library`: headers, archives or shared libraries, CMake package, pkg-config files; they need the standard library alone),
# and the command (component `command`, see apps/).

include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/waybreaker)

set(libraries waybreaker)
set(pc_files waybreaker)
if(TARGET waybreaker_c)
  list(APPEND libraries waybreaker_c)
  list(APPEND pc_files waybreaker-c)
  install(FILES include/waybreaker.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT library)
endif()
install(TARGETS ${libraries} EXPORT waybreaker
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
foreach(pc IN LISTS pc_files)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/${pc}.pc.in ${pc}.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${pc}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT library)
endforeach()
