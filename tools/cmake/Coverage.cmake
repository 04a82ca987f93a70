# For -DCMAKE_PROJECT_INCLUDE: hand-written code counts the lines that run. Without inlining, a line that has run is
# one that is counted.
file(GLOB sources ${PROJECT_SOURCE_DIR}/src/*/*.c ${PROJECT_SOURCE_DIR}/codegen/*/*.c
     ${PROJECT_SOURCE_DIR}/tools/bench/program/*.c)
cmake_language(DEFER CALL set_property SOURCE ${sources} APPEND PROPERTY COMPILE_OPTIONS -O1 -fno-inline --coverage)
link_libraries(--coverage)
