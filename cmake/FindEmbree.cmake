# Embree 4 (Debian 13) or 3 (Debian 11 and 12, Ubuntu 20.04 and 22.04), whichever is there.
#   Embree_FOUND, Embree_VERSION_MAJOR, imported target Embree::Embree
# The distributions' own config files differ in name and folder from release to release, so we look for the files.
find_path(Embree_INCLUDE_DIR NAMES embree4/rtcore.h embree3/rtcore.h)
if(Embree_INCLUDE_DIR AND EXISTS "${Embree_INCLUDE_DIR}/embree4/rtcore.h")
  set(Embree_VERSION_MAJOR 4)
else()
  set(Embree_VERSION_MAJOR 3)
endif()
find_library(Embree_LIBRARY NAMES embree${Embree_VERSION_MAJOR})
mark_as_advanced(Embree_INCLUDE_DIR Embree_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Embree REQUIRED_VARS Embree_LIBRARY Embree_INCLUDE_DIR)

if(Embree_FOUND AND NOT TARGET Embree::Embree)
  add_library(Embree::Embree UNKNOWN IMPORTED)
  set_target_properties(Embree::Embree PROPERTIES
    IMPORTED_LOCATION "${Embree_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${Embree_INCLUDE_DIR}"
    INTERFACE_COMPILE_DEFINITIONS POLYGONAL_PERCEPTION_EMBREE_VERSION=${Embree_VERSION_MAJOR})
endif()
