# The targets asperity::asperity and asperity::static, as they are in a build tree. cargo is always run: it knows what
# is out of date. Its libraries are copied to where the name in the soname stands beside the shared one.
set(ASPERITY_STAGE "${CMAKE_CURRENT_BINARY_DIR}/lib")

set(asperity_rustc_args "--print=native-static-libs=${asperity_target_dir}/${ASPERITY_RUST_TARGET}/native-static-libs")
if(ASPERITY_SONAME_FLAG)
  list(APPEND asperity_rustc_args -C "link-arg=${ASPERITY_SONAME_FLAG}")
endif()
set(asperity_environment)
if(CMAKE_OSX_DEPLOYMENT_TARGET)
  set(asperity_environment "MACOSX_DEPLOYMENT_TARGET=${CMAKE_OSX_DEPLOYMENT_TARGET}")
endif()
# A cross compiler that needs no options links for its machine; Rust's own default is the host's `cc`.
string(TOUPPER "CARGO_TARGET_${ASPERITY_RUST_TARGET}_LINKER" asperity_linker)
string(REPLACE "-" "_" asperity_linker "${asperity_linker}")
if(CMAKE_CROSSCOMPILING AND CMAKE_C_COMPILER_ID STREQUAL "GNU" AND NOT DEFINED ENV{${asperity_linker}})
  list(APPEND asperity_environment "${asperity_linker}=${CMAKE_C_COMPILER}")
endif()

set(asperity_stage_commands
  COMMAND "${CMAKE_COMMAND}" -E make_directory "${ASPERITY_STAGE}"
  COMMAND "${CMAKE_COMMAND}" -E copy_if_different
          "${ASPERITY_CARGO_DIR}/${ASPERITY_CARGO_SHARED}" "${ASPERITY_STAGE}/${ASPERITY_SHARED_FILE}")
set(asperity_byproducts "${ASPERITY_STAGE}/${ASPERITY_SHARED_FILE}" "${ASPERITY_STAGE}/${ASPERITY_STATIC_FILE}")
# The static library as it links beside others of Rust. On Windows, which has no shell for that, it stays as
# cargo made it.
set(asperity_copy_static "${CMAKE_COMMAND}" -E copy_if_different)
if(CMAKE_HOST_UNIX)
  set(asperity_copy_static "${PROJECT_SOURCE_DIR}/cmake/own_symbols.sh" "${ASPERITY_RUSTC}")
endif()
list(APPEND asperity_stage_commands
  COMMAND ${asperity_copy_static} "${ASPERITY_CARGO_DIR}/${ASPERITY_STATIC_FILE}" "${ASPERITY_STAGE}/${ASPERITY_STATIC_FILE}")
if(ASPERITY_IMPORT_FILE)
  list(APPEND asperity_stage_commands
    COMMAND "${CMAKE_COMMAND}" -E copy_if_different
            "${ASPERITY_CARGO_DIR}/${ASPERITY_IMPORT_FILE}" "${ASPERITY_STAGE}/${ASPERITY_IMPORT_FILE}")
endif()
foreach(link IN LISTS ASPERITY_SHARED_LINKS)
  list(APPEND asperity_stage_commands
    COMMAND "${CMAKE_COMMAND}" -E create_symlink "${ASPERITY_SHARED_FILE}" "${ASPERITY_STAGE}/${link}")
endforeach()
if(ASPERITY_IMPORT_FILE)
  list(APPEND asperity_byproducts "${ASPERITY_STAGE}/${ASPERITY_IMPORT_FILE}")
endif()

if(ASPERITY_INSTALL)
  set(asperity_all ALL)
else()
  set(asperity_all)
endif()
add_custom_target(asperity_cargo ${asperity_all}
  COMMAND "${CMAKE_COMMAND}" -E env ${asperity_environment}
          "${ASPERITY_CARGO}" rustc --release --locked --lib --crate-type cdylib,staticlib
          --manifest-path "${PROJECT_SOURCE_DIR}/Cargo.toml"
          --target "${ASPERITY_RUST_TARGET}" --target-dir "${asperity_target_dir}"
          -- ${asperity_rustc_args}
  ${asperity_stage_commands}
  BYPRODUCTS ${asperity_byproducts}
  COMMENT "Building asperity with cargo"
  USES_TERMINAL VERBATIM)

add_library(asperity::asperity SHARED IMPORTED GLOBAL)
set_target_properties(asperity::asperity PROPERTIES
  IMPORTED_LOCATION "${ASPERITY_STAGE}/${ASPERITY_SHARED_FILE}"
  INTERFACE_INCLUDE_DIRECTORIES "${PROJECT_SOURCE_DIR}/include")
if(ASPERITY_IMPORT_FILE)
  set_target_properties(asperity::asperity PROPERTIES IMPORTED_IMPLIB "${ASPERITY_STAGE}/${ASPERITY_IMPORT_FILE}")
else()
  set_target_properties(asperity::asperity PROPERTIES IMPORTED_SONAME "${ASPERITY_SONAME}")
endif()

add_library(asperity::static STATIC IMPORTED GLOBAL)
set_target_properties(asperity::static PROPERTIES
  IMPORTED_LOCATION "${ASPERITY_STAGE}/${ASPERITY_STATIC_FILE}"
  INTERFACE_INCLUDE_DIRECTORIES "${PROJECT_SOURCE_DIR}/include"
  INTERFACE_LINK_LIBRARIES "${ASPERITY_NATIVE_LIBS}")

add_dependencies(asperity::asperity asperity_cargo)
add_dependencies(asperity::static asperity_cargo)
