# How peers are compiled: with little optimisation, in two thirds of the time, for tests need no more. A toolchain file, as CMake
# lets no other come from outside of a script that calls it with -DCMAKE_BUILD_TYPE=Release.
set(CMAKE_CXX_FLAGS_RELEASE "-O1 -DNDEBUG" CACHE STRING "")
