# SPDX-License-Identifier: Apache-2.0
include(GoogleTest)

# candela_room(name [ROOMS other...] [DOOR third-party-target...] [SOURCES file...]
#              [TEST_ROOMS other...])
#
# One library a room. ROOMS are the rooms it builds upon; DOOR names the third-party libraries
# that this room alone opens (nothing of them leaves it). Without SOURCES every .cpp beside the
# CMakeLists.txt is taken; files that end in _test.cpp become the room's test program, which may use
# TEST_ROOMS besides.
function(candela_room name)
    cmake_parse_arguments(ROOM "" "" "ROOMS;DOOR;SOURCES;TEST_ROOMS" ${ARGN})
    if(NOT ROOM_SOURCES)
        file(GLOB ROOM_SOURCES CONFIGURE_DEPENDS *.cpp)
    endif()
    set(tests ${ROOM_SOURCES})
    list(FILTER tests INCLUDE REGEX "_test\\.cpp$")
    list(FILTER ROOM_SOURCES EXCLUDE REGEX "_test\\.cpp$")

    if(ROOM_SOURCES)
        add_library(${name} STATIC ${ROOM_SOURCES})
        # The same objects become the program and libcandela.so. Hidden names are called directly,
        # which makes them as fast as those of a program.
        set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON
            CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
        target_include_directories(${name} PUBLIC ${CMAKE_SOURCE_DIR}/src)
        target_link_libraries(${name} PUBLIC ${ROOM_ROOMS} PRIVATE ${ROOM_DOOR})
    else()
        add_library(${name} INTERFACE)
        target_include_directories(${name} INTERFACE ${CMAKE_SOURCE_DIR}/src)
        target_link_libraries(${name} INTERFACE ${ROOM_ROOMS})
    endif()
    if(tests)
        candela_test(${name}_test SOURCES ${tests} ROOMS ${name} ${ROOM_TEST_ROOMS} LABELS unit)
    endif()
endfunction()

# candela_rooms_below(variable room): the room and all that it builds upon, those of headers left out.
function(candela_rooms_below variable name)
    set(found "")
    set(open ${name})
    while(open)
        list(POP_FRONT open room)
        if(NOT TARGET ${room} OR room IN_LIST found)
            continue()
        endif()
        get_target_property(kind ${room} TYPE)
        get_target_property(imported ${room} IMPORTED)
        if(imported)
            continue()
        endif()
        get_target_property(steps ${room} INTERFACE_LINK_LIBRARIES)
        if(steps)
            list(APPEND open ${steps})
        endif()
        if(kind STREQUAL STATIC_LIBRARY)
            list(APPEND found ${room})
        endif()
    endwhile()
    set(${variable} ${found} PARENT_SCOPE)
endfunction()

# candela_test(name SOURCES file... ROOMS room... [LABELS label...]): a GoogleTest program.
# Tests find the source tree and the build tree through CANDELA_SOURCE_DIR and CANDELA_BINARY_DIR.
# The global property CANDELA_UNIT_TESTS names them all.
function(candela_test name)
    cmake_parse_arguments(TEST "" "" "SOURCES;ROOMS;LABELS" ${ARGN})
    set_property(GLOBAL APPEND PROPERTY CANDELA_UNIT_TESTS ${name})
    add_executable(${name} ${TEST_SOURCES})
    target_link_libraries(${name} PRIVATE ${TEST_ROOMS} GTest::gtest GTest::gtest_main)
    target_compile_definitions(${name} PRIVATE CANDELA_SOURCE_DIR="${CMAKE_SOURCE_DIR}"
                                               CANDELA_BINARY_DIR="${CMAKE_BINARY_DIR}")
    add_test(NAME ${name} COMMAND ${name})
    set_tests_properties(${name} PROPERTIES LABELS "${TEST_LABELS}" TIMEOUT 600
        ENVIRONMENT "CANDELA_CACHE=${CMAKE_BINARY_DIR}/shader-cache;CANDELA_SHADERS=${CMAKE_SOURCE_DIR}/shaders")
endfunction()
