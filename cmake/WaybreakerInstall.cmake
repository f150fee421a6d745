# cmake --install: the library an embedding program links (standard library only) and, if built, the command.

include(CMakePackageConfigHelpers)

install(TARGETS waybreaker ${WAYBREAKER_CORE_TARGETS} EXPORT waybreaker)
install(DIRECTORY include/waybreaker DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT waybreaker NAMESPACE waybreaker:: FILE waybreaker-config.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/waybreaker)
write_basic_package_version_file(waybreaker-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/waybreaker-config-version.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/waybreaker)
