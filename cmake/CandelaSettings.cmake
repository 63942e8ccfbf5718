# SPDX-License-Identifier: Apache-2.0
# How everything is compiled.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release)
endif()

# No contraction and no fast-math anywhere: a picture is the same at every lane width (DESIGN 3).
# -fno-math-errno and -fno-trapping-math change no result.
add_compile_options(-Wall -Wextra -ffp-contract=off -fno-math-errno -fno-trapping-math)
if(DEFINED ENV{CI})
    add_compile_options(-Werror)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
set(CMAKE_CXX_FLAGS_ASAN "-O1 -g -fno-omit-frame-pointer -fsanitize=address,undefined,float-cast-overflow")
set(CMAKE_CXX_FLAGS_TSAN "-O1 -g -fsanitize=thread")

find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()
find_program(MOLD mold)
if(MOLD)
    add_link_options(-fuse-ld=mold)
endif()

find_package(TBB REQUIRED)
find_package(fmt REQUIRED)
find_package(ZLIB REQUIRED)
find_package(PNG REQUIRED)
find_package(OpenEXR CONFIG REQUIRED)
find_package(embree 3 CONFIG REQUIRED)
find_package(LLVM 19.1 CONFIG REQUIRED)
find_package(CLI11 CONFIG REQUIRED)
find_package(GTest REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(SLEEF REQUIRED IMPORTED_TARGET sleef)
# Not a pyenv shim that happens to come first in PATH.
set(Python3_EXECUTABLE /usr/bin/python3)
find_package(Python3 REQUIRED COMPONENTS Interpreter)

# OpenImageIO's own package file asks for development files of all formats that it reads.
find_path(OPENIMAGEIO_INCLUDE_DIR OpenImageIO/texture.h REQUIRED)
find_library(OPENIMAGEIO_LIBRARY OpenImageIO REQUIRED)
find_library(OPENIMAGEIO_UTIL_LIBRARY OpenImageIO_Util REQUIRED)
find_package(Imath CONFIG REQUIRED)
add_library(OpenImageIO::OpenImageIO INTERFACE IMPORTED)
target_include_directories(OpenImageIO::OpenImageIO SYSTEM INTERFACE ${OPENIMAGEIO_INCLUDE_DIR})
target_link_libraries(OpenImageIO::OpenImageIO INTERFACE ${OPENIMAGEIO_LIBRARY}
    ${OPENIMAGEIO_UTIL_LIBRARY} Imath::Imath fmt::fmt)

# OpenSubdiv's own package file asks for libraries that Debian leaves out, even with QUIET.
find_path(OPENSUBDIV_INCLUDE_DIR opensubdiv/far/patchTable.h REQUIRED)
find_library(OPENSUBDIV_LIBRARY osdCPU REQUIRED)
add_library(OpenSubdiv::osdCPU INTERFACE IMPORTED)
target_include_directories(OpenSubdiv::osdCPU SYSTEM INTERFACE ${OPENSUBDIV_INCLUDE_DIR})
target_link_libraries(OpenSubdiv::osdCPU INTERFACE ${OPENSUBDIV_LIBRARY})
