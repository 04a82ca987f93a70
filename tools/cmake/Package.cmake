# What `cpack -G DEB` makes of an installed tree: jellett_VERSION_ARCHITECTURE.deb, one package with programs, library, headers, kernels,
# models and man pages. Libraries that programs and library are linked with are found by dpkg-shlibdeps (dpkg-dev, file).
set(CPACK_PACKAGE_NAME jellett)
set(CPACK_PACKAGE_CONTACT "The jellett authors <authors@jellett.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DESCRIPTION
  "ttc proves what a table of terms claims of a mechanical system and compiles it to C; jellett follows its orbits, maps, periodic\n\
orbits and bifurcations. The library does the same for programs in C, in C++, and behind opaque handles in other languages.")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/tools/cmake/PackagePermissions.cmake)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
# `ttc build` runs a C compiler, with Arb's headers where they are there; pictures are drawn by gnuplot.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "gcc, libc6-dev, libflint-dev, gnuplot-nox")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "pkg-config, libgsl-dev, libarpack2-dev, libjansson-dev, libconfig-dev")
include(CPack)
