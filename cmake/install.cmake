# `cmake --install`: the same files as `make install` (cmake/install.mk).
include(GNUInstallDirs)

set(ASPERITY_VERSION "${PROJECT_VERSION}")
set(ASPERITY_VERSION_MAJOR "${PROJECT_VERSION_MAJOR}")
set(ASPERITY_POINTER_SIZE "${CMAKE_SIZEOF_VOID_P}")

# ---- Paths in the installed files start from those files, unless the user chose absolute folders ----
function(asperity_path result folder prefix)
  if(IS_ABSOLUTE "${folder}")
    set(${result} "${folder}" PARENT_SCOPE)
  else()
    set(${result} "${prefix}/${folder}" PARENT_SCOPE)
  endif()
endfunction()

if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}")
  set(ASPERITY_PC_PREFIX "${CMAKE_INSTALL_PREFIX}")
  set(ASPERITY_CMAKE_PREFIX "${CMAKE_INSTALL_PREFIX}")
else()
  string(REGEX REPLACE "[^/]+" ".." asperity_up "${CMAKE_INSTALL_LIBDIR}")
  set(ASPERITY_PC_PREFIX "\${pcfiledir}/${asperity_up}/..")
  set(ASPERITY_CMAKE_PREFIX "\${_asperity_libdir}/${asperity_up}")
endif()
asperity_path(ASPERITY_PC_LIBDIR "${CMAKE_INSTALL_LIBDIR}" "\${prefix}")
asperity_path(ASPERITY_PC_INCLUDEDIR "${CMAKE_INSTALL_INCLUDEDIR}" "\${prefix}")
asperity_path(ASPERITY_PC_DATADIR "${CMAKE_INSTALL_DATADIR}" "\${prefix}")
foreach(asperity_place IN ITEMS PREFIX LIBDIR INCLUDEDIR DATADIR)
  string(REPLACE " " "\\ " ASPERITY_PC_${asperity_place} "${ASPERITY_PC_${asperity_place}}")
endforeach()
asperity_path(ASPERITY_CMAKE_INCLUDEDIR "${CMAKE_INSTALL_INCLUDEDIR}" "\${_asperity_prefix}")
asperity_path(ASPERITY_CMAKE_DATADIR "${CMAKE_INSTALL_DATADIR}" "\${_asperity_prefix}")

if(ASPERITY_IMPORT_FILE)
  asperity_path(asperity_bindir "${CMAKE_INSTALL_BINDIR}" "\${_asperity_prefix}")
  set(ASPERITY_CMAKE_SHARED "${asperity_bindir}/${ASPERITY_SHARED_FILE}")
  set(ASPERITY_CMAKE_LINK_PROPERTY "IMPORTED_IMPLIB \"\${_asperity_libdir}/${ASPERITY_IMPORT_FILE}\"")
  set(asperity_shared_destination "${CMAKE_INSTALL_BINDIR}")
else()
  set(ASPERITY_CMAKE_SHARED "\${_asperity_libdir}/${ASPERITY_SHARED_FILE}")
  set(ASPERITY_CMAKE_LINK_PROPERTY "IMPORTED_SONAME \"${ASPERITY_SONAME}\"")
  set(asperity_shared_destination "${CMAKE_INSTALL_LIBDIR}")
endif()

# ---- Generated files ----
set(ASPERITY_CMAKE_NATIVE_LIBS "${ASPERITY_NATIVE_LIBS}")
string(REPLACE ";" " " ASPERITY_NATIVE_LIBS "${ASPERITY_NATIVE_LIBS}")
foreach(file IN ITEMS asperity.pc asperity-config.cmake asperity-config-version.cmake)
  configure_file("cmake/${file}.in" "${CMAKE_CURRENT_BINARY_DIR}/${file}" @ONLY)
endforeach()

# ---- Rules ----
install(PROGRAMS "${ASPERITY_STAGE}/${ASPERITY_SHARED_FILE}" DESTINATION "${asperity_shared_destination}")
foreach(file IN LISTS ASPERITY_STATIC_FILE ASPERITY_IMPORT_FILE ASPERITY_SHARED_LINKS)
  install(FILES "${ASPERITY_STAGE}/${file}" DESTINATION "${CMAKE_INSTALL_LIBDIR}")
endforeach()
install(DIRECTORY include/ DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp")
install(FILES fortran/asperity.f90 DESTINATION "${CMAKE_INSTALL_DATADIR}/asperity/fortran")
install(FILES LICENSE-MIT LICENSE-APACHE DESTINATION "${CMAKE_INSTALL_DATADIR}/licenses/asperity")
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/asperity.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/asperity-config.cmake"
              "${CMAKE_CURRENT_BINARY_DIR}/asperity-config-version.cmake"
        DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/asperity")
