# SPDX-License-Identifier: Apache-2.0
# What `cmake --install build` puts where. An installation finds all of its parts by where they lie
# to each other (foundation/base/installation.h), so it may be moved whole.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS candela)
install(TARGETS libcandela EXPORT Candela)
install(FILES ${CMAKE_BINARY_DIR}/lib/libcandela.a DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS candela_pictures DESTINATION lib/candela)
if(TARGET candela_window)
    install(TARGETS candela_window DESTINATION lib/candela)
endif()
install(FILES include/ri.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY shaders DESTINATION share/candela)

# The build tree looks alike.
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/share/candela)
file(CREATE_LINK ${CMAKE_SOURCE_DIR}/shaders ${CMAKE_BINARY_DIR}/share/candela/shaders SYMBOLIC)

# For `pkg-config candela`
set(package_folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH prefix_from_package /${package_folder} /)
configure_file(cmake/candela.pc.in candela.pc @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/candela.pc DESTINATION ${package_folder})

# For find_package(Candela)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Candela)
install(EXPORT Candela NAMESPACE Candela:: FILE CandelaConfig.cmake DESTINATION ${package_folder})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/CandelaConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/CandelaConfigVersion.cmake DESTINATION ${package_folder})
