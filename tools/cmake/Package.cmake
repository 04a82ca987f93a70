# What `cpack -G DEB` makes of an installed tree, by its components: jellett (programs, models, scenes, man pages, completion),
# libjellett0 (the shared library) and libjellett-dev (headers, kernels, the static library, and how to find them).
# Libraries that programs and library are linked with are found by dpkg-shlibdeps (dpkg-dev, file).
set(CPACK_COMPONENTS_ALL programs library development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGE_NAME jellett)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}") # the first line of what is said of each
set(CPACK_PACKAGE_CONTACT "The jellett authors <authors@jellett.invalid>")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/tools/cmake/PackageFiles.cmake)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)

set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME jellett)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAMS_DESCRIPTION "ttc proves what a table of terms claims of a mechanical system, and compiles
it to C. jellett follows orbits of such systems, their Poincare maps, periodic
orbits, separatrices and bifurcations.")
# `ttc prove` runs QEPCAD, `ttc build` a C compiler, with Arb's headers where they are there; pictures are drawn by gnuplot.
# Where Arb is not a part of FLINT (before its version 3) it has headers of its own.
if(Arb_LIBRARY)
  set(flint "libflint-dev, libflint-arb-dev")
else()
  set(flint "libflint-dev")
endif()
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_DEPENDS qepcad)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_RECOMMENDS "gcc, libc6-dev, ${flint}, gnuplot-nox")

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libjellett0)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/tools/debian/triggers)
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "The shared library follows orbits of mechanical systems, their Poincare maps,
periodic orbits and bifurcations, for programs in C and C++, and behind opaque
handles for other languages.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libjellett-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libjellett0 (= ${PROJECT_VERSION})")
# What the static library is linked with.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS
  "pkg-config, g++, libgsl-dev, libarpack2-dev, liblapack-dev, ${flint}, libjansson-dev, libconfig-dev")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "Headers of libjellett0, the static library, kernels in C, examples, and what
pkg-config and CMake need to find them.")
include(CPack)
