# How the libraries and tests of this package are made: includes, warnings and visibility by target.

option(POLYGONAL_PERCEPTION_UNITY_BUILD "The files of a target are compiled in few pieces: all of them, with the tests, in five sixths of the time; \
off, one that has changed is compiled sooner" ON)

# For everything that is compiled here. Nothing of it reaches who links with us.
add_library(polygonal_perception_warnings INTERFACE)
target_compile_options(polygonal_perception_warnings INTERFACE -Wall -Wextra -Wpedantic)

# Third-party headers warn for themselves.
add_library(polygonal_perception_catkin INTERFACE)
target_include_directories(polygonal_perception_catkin SYSTEM INTERFACE
  ${CATKIN_DEVEL_PREFIX}/include ${catkin_INCLUDE_DIRS})
target_link_libraries(polygonal_perception_catkin INTERFACE ${catkin_LIBRARIES})
add_library(polygonal_perception_opencv INTERFACE)
target_include_directories(polygonal_perception_opencv SYSTEM INTERFACE ${OpenCV_INCLUDE_DIRS})
target_link_libraries(polygonal_perception_opencv INTERFACE ${OpenCV_LIBRARIES})

set(POLYGONAL_PERCEPTION_GENERATED ${${PROJECT_NAME}_EXPORTED_TARGETS} ${catkin_EXPORTED_TARGETS})

# room_library(<name> SOURCES <file>... [LINK <library>...] [PRIVATE_LINK <library>...])
#
# A shared library of which the outside sees what its public headers export, and no more. <name>_objects is what it is
# made of: a test that links that instead of the library reaches the room's private classes, and its private headers as
# "room/header.hpp".
function(room_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK;PRIVATE_LINK" ${ARGN})
  add_library(${name}_objects OBJECT ${ARG_SOURCES})
  set_target_properties(${name}_objects PROPERTIES
    POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
    UNITY_BUILD ${POLYGONAL_PERCEPTION_UNITY_BUILD})
  target_include_directories(${name}_objects PUBLIC ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${name}_objects
    PUBLIC ${ARG_LINK} ${ARG_PRIVATE_LINK}
    PRIVATE polygonal_perception_warnings)
  add_dependencies(${name}_objects ${POLYGONAL_PERCEPTION_GENERATED})

  add_library(${name} SHARED $<TARGET_OBJECTS:${name}_objects>)
  set_target_properties(${name} PROPERTIES LINKER_LANGUAGE CXX)
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR}/include)
  target_link_libraries(${name} PUBLIC ${ARG_LINK} PRIVATE ${ARG_PRIVATE_LINK})
endfunction()

# install_room(<library>...): what runs; the headers are installed by their folders.
function(install_room)
  install(TARGETS ${ARGN}
    ARCHIVE DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
    LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION}
    RUNTIME DESTINATION ${CATKIN_GLOBAL_BIN_DESTINATION})
endfunction()

# install_headers(<folder below include/polygonal_perception>...)
function(install_headers)
  foreach(folder ${ARGN})
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/${PROJECT_NAME}/${folder}/
      DESTINATION ${CATKIN_PACKAGE_INCLUDE_DESTINATION}/${folder})
  endforeach()
endfunction()

# compiled_here(<target>...): programs and tests.
function(compiled_here)
  foreach(target ${ARGN})
    set_target_properties(${target} PROPERTIES UNITY_BUILD ${POLYGONAL_PERCEPTION_UNITY_BUILD})
    target_link_libraries(${target} polygonal_perception_warnings)
  endforeach()
endfunction()
