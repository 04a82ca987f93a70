# Run by cpack before it packs: what Debian wants of every package beside the installed files.
foreach(component ${CPACK_COMPONENTS_ALL})
  string(TOUPPER ${component} COMPONENT)
  set(tree ${CPACK_TEMPORARY_DIRECTORY}/${component}${CPACK_PACKAGING_INSTALL_PREFIX}/share)
  set(doc ${tree}/doc/${CPACK_DEBIAN_${COMPONENT}_PACKAGE_NAME})
  file(MAKE_DIRECTORY ${doc})
  file(COPY ${CMAKE_CURRENT_LIST_DIR}/../debian/copyright ${CMAKE_CURRENT_LIST_DIR}/../debian/changelog DESTINATION ${doc}
       FILE_PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
  file(REMOVE ${doc}/LICENSE) # the copyright file says where it is
  file(GLOB texts ${tree}/man/man1/*.1)
  execute_process(COMMAND gzip -9n ${doc}/changelog ${texts} COMMAND_ERROR_IS_FATAL ANY)
  # Debian's zsh looks elsewhere than zsh does by itself.
  if(EXISTS ${tree}/zsh/site-functions)
    file(RENAME ${tree}/zsh/site-functions ${tree}/zsh/vendor-completions)
  endif()
endforeach()
# Folders can be read by everybody, whatever the umask of whoever makes the packages.
file(GLOB_RECURSE paths LIST_DIRECTORIES true ${CPACK_TEMPORARY_DIRECTORY}/*)
foreach(path ${paths})
  if(IS_DIRECTORY ${path})
    file(CHMOD ${path} PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  endif()
endforeach()
