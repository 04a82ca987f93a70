# What `cmake --install` lays down: programs, libraries, headers, kernels, models, scenes, man pages, completion, and how to
# find them by pkg-config (jellett) and by CMake (find_package(jellett): jellett::shared, jellett::static). Components become
# packages (Package.cmake).
include(CMakePackageConfigHelpers)

set(JLT_INSTALL_HEADERS ${CMAKE_INSTALL_INCLUDEDIR}/jellett)
set(JLT_INSTALL_DATA ${CMAKE_INSTALL_DATADIR}/jellett)
set(JLT_INSTALL_PACKAGE ${CMAKE_INSTALL_LIBDIR}/cmake/jellett)

install(TARGETS ttc jellett RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT programs)
install(TARGETS jellett-bench RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/jellett COMPONENT programs)
# Two exports, so that a user of the shared library need not have what only the static one is linked with.
install(TARGETS jellett_shared EXPORT jellett-shared
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development)
install(TARGETS jellett_static EXPORT jellett-static ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
foreach(kind shared static)
  install(EXPORT jellett-${kind} NAMESPACE jellett:: FILE jellett-${kind}.cmake DESTINATION ${JLT_INSTALL_PACKAGE}
          COMPONENT development)
endforeach()

# Headers keep their folders, so that #include "core/status.h" means the same here and there.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/ ${PROJECT_SOURCE_DIR}/generated/ DESTINATION ${JLT_INSTALL_HEADERS}
        COMPONENT development
        FILES_MATCHING PATTERN "*.h" PATTERN "spectrum" EXCLUDE PATTERN "validated" EXCLUDE PATTERN "claims" EXCLUDE
        PATTERN "shards" EXCLUDE PATTERN "cli" EXCLUDE PATTERN "command_*" EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/generated ${PROJECT_SOURCE_DIR}/tools/examples
        DESTINATION ${JLT_INSTALL_DATA} COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/codegen/models ${PROJECT_SOURCE_DIR}/tools/scenes ${PROJECT_SOURCE_DIR}/tools/certificates
        DESTINATION ${JLT_INSTALL_DATA} COMPONENT programs
        FILES_MATCHING PATTERN "*.tt" PATTERN "*.scene" PATTERN "*.json" PATTERN "results" EXCLUDE)
file(GLOB job_scripts CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tools/scenes/sweep-*)
install(PROGRAMS ${job_scripts} DESTINATION ${JLT_INSTALL_DATA}/scenes COMPONENT programs)
# Man pages, one a command beside that of the program, are made of what the programs say of themselves, so that they
# cannot disagree.
foreach(program ttc jellett)
  set(page ${CMAKE_BINARY_DIR}/man/${program}.1)
  set(template ${PROJECT_SOURCE_DIR}/tools/man/${program}.1.in)
  add_custom_command(OUTPUT ${page} VERBATIM
    DEPENDS ${program} jellett-bench ${template} ${PROJECT_SOURCE_DIR}/tools/man/pages ${PROJECT_SOURCE_DIR}/tools/man/page.awk
            ${PROJECT_SOURCE_DIR}/tools/completion/complete
    COMMAND bash ${PROJECT_SOURCE_DIR}/tools/man/pages $<TARGET_FILE:${program}> ${template} ${CMAKE_BINARY_DIR}/man)
  list(APPEND JLT_MAN_PAGES ${page})
endforeach()
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/man)
add_custom_target(man ALL DEPENDS ${JLT_MAN_PAGES})
install(DIRECTORY ${CMAKE_BINARY_DIR}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT programs FILES_MATCHING PATTERN "*.1")

# Completion asks the programs what they have: one script that knows how, beside them in the build too, and one for each shell.
configure_file(${PROJECT_SOURCE_DIR}/tools/completion/complete ${CMAKE_BINARY_DIR}/share/jellett/complete COPYONLY)
install(PROGRAMS ${PROJECT_SOURCE_DIR}/tools/completion/complete DESTINATION ${JLT_INSTALL_DATA} COMPONENT programs)
foreach(program ttc jellett)
  install(FILES ${PROJECT_SOURCE_DIR}/tools/completion/jellett.bash RENAME ${program}
          DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT programs)
  install(FILES ${PROJECT_SOURCE_DIR}/tools/completion/jellett.fish RENAME ${program}.fish
          DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT programs)
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/tools/completion/_jellett DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions
        COMPONENT programs)

install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/CITATION.cff
        DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT programs)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/tools/docs DESTINATION ${CMAKE_INSTALL_DOCDIR}/tools COMPONENT programs
        FILES_MATCHING PATTERN "*.md" PATTERN "*.tt" PATTERN "site" EXCLUDE)
# What these pages lead to keeps its place beside them.
foreach(page codegen/README.md src/README.md tests/README.md tests/stability/README.md tools/bench/README.md
             tools/bench/results/figures.md tools/bench/results/speed.png tools/scenes/README.md tools/scenes/results/figure3.png)
  get_filename_component(folder ${page} DIRECTORY)
  install(FILES ${PROJECT_SOURCE_DIR}/${page} DESTINATION ${CMAKE_INSTALL_DOCDIR}/${folder} COMPONENT programs)
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/tools/examples DESTINATION ${CMAKE_INSTALL_DOCDIR}/tools COMPONENT programs
        FILES_MATCHING PATTERN "*.c")

configure_package_config_file(${PROJECT_SOURCE_DIR}/tools/cmake/jellett-config.cmake.in
  ${CMAKE_BINARY_DIR}/package/jellett-config.cmake INSTALL_DESTINATION ${JLT_INSTALL_PACKAGE})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/package/jellett-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/package/jellett-config.cmake ${CMAKE_BINARY_DIR}/package/jellett-config-version.cmake
        ${PROJECT_SOURCE_DIR}/tools/cmake/FindFlint.cmake DESTINATION ${JLT_INSTALL_PACKAGE} COMPONENT development)

# The .pc file finds its prefix from where it lies, so that a tree installed elsewhere, or moved, still works.
file(RELATIVE_PATH JLT_PREFIX_FROM_PC /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" JLT_PREFIX_FROM_PC "${JLT_PREFIX_FROM_PC}")
# What only the static library must be linked with stands there by its flags: names of other .pc files would be looked for by
# users of the shared library too.
set(JLT_PC_LIBRARIES "")
foreach(library ${Flint_libraries} ${OpenMP_C_LIBRARIES})
  get_filename_component(stem ${library} NAME_WE)
  get_filename_component(folder ${library} DIRECTORY)
  if(NOT folder IN_LIST CMAKE_C_IMPLICIT_LINK_DIRECTORIES)
    list(APPEND JLT_PC_LIBRARIES -L${folder})
  endif()
  string(REGEX REPLACE "^lib" "-l" flag ${stem})
  list(APPEND JLT_PC_LIBRARIES ${flag})
endforeach()
foreach(package GSL ARPACK LAPACK JANSSON LIBCONFIG)
  list(APPEND JLT_PC_LIBRARIES ${${package}_STATIC_LDFLAGS})
endforeach()
# Where the compiler looks by itself differs between machines, and need not be said.
foreach(folder ${CMAKE_C_IMPLICIT_LINK_DIRECTORIES})
  list(REMOVE_ITEM JLT_PC_LIBRARIES -L${folder})
endforeach()
list(REMOVE_DUPLICATES JLT_PC_LIBRARIES)
list(REMOVE_ITEM JLT_PC_LIBRARIES -lm)
string(JOIN " " JLT_PC_LIBRARIES ${JLT_PC_LIBRARIES} -lstdc++ -lm)
configure_file(${PROJECT_SOURCE_DIR}/tools/cmake/jellett.pc.in ${CMAKE_BINARY_DIR}/package/jellett.pc @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/package/jellett.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
