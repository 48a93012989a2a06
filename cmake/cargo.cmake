# What cargo and rustc must be asked, and what their files are called on the target platform.
#
# In:  ASPERITY_RUST_TARGET, the target triple (in cross compilation the C compiler's by default, else rustc's host);
#      environment CARGO_TARGET_DIR, shared with `make install` where it is set.
# Out: ASPERITY_CARGO_DIR and the file names in it, ASPERITY_SONAME, ASPERITY_NATIVE_LIBS.

find_program(ASPERITY_CARGO cargo HINTS "$ENV{CARGO_HOME}/bin" "$ENV{HOME}/.cargo/bin" "$ENV{USERPROFILE}/.cargo/bin")
find_program(ASPERITY_RUSTC rustc HINTS "$ENV{CARGO_HOME}/bin" "$ENV{HOME}/.cargo/bin" "$ENV{USERPROFILE}/.cargo/bin")
mark_as_advanced(ASPERITY_CARGO ASPERITY_RUSTC)

# ---- Is Rust new enough? ----
# In the words of cmake/check_rust.sh, which needs a shell.
file(STRINGS Cargo.toml asperity_rust REGEX "^rust-version = " LIMIT_COUNT 1)
string(REGEX MATCH "[0-9.]+" asperity_rust "${asperity_rust}")
foreach(program IN ITEMS "${ASPERITY_CARGO}" "${ASPERITY_RUSTC}")
  set(asperity_found "")
  if(program)
    execute_process(COMMAND "${program}" --version OUTPUT_VARIABLE asperity_found ERROR_QUIET)
    string(REGEX MATCH "[0-9]+\\.[0-9]+" asperity_found "${asperity_found}")
  endif()
  if(NOT asperity_found)
    message(FATAL_ERROR "asperity needs Rust ${asperity_rust} or later (found none): https://rustup.rs\n"
                        "Where it is elsewhere, set ASPERITY_CARGO and ASPERITY_RUSTC.")
  elseif(asperity_found VERSION_LESS asperity_rust)
    message(FATAL_ERROR "asperity needs Rust ${asperity_rust} or later (found ${asperity_found}): https://rustup.rs")
  endif()
endforeach()

# ---- Target triple ----
# Rust's name for what the C compiler calls its machine, or nothing. 32-bit ARM has several for one of GCC's.
function(asperity_triple_of_compiler result_triple result_machine)
  set(target_flag)
  if(CMAKE_C_COMPILER_TARGET)
    set(target_flag "${CMAKE_C_COMPILE_OPTIONS_TARGET}${CMAKE_C_COMPILER_TARGET}")
  endif()
  execute_process(COMMAND "${CMAKE_C_COMPILER}" ${target_flag} -dumpmachine
    OUTPUT_VARIABLE machine ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  set(triple)
  if(machine MATCHES "^(x86_64|i686)-w64-(mingw32|windows-gnu)$")
    set(triple "${CMAKE_MATCH_1}-pc-windows-gnu")
  elseif(machine MATCHES "^(x86_64|i686|aarch64|powerpc64|powerpc64le|s390x)-([a-z0-9]+-)?linux-(gnu|musl)$")
    set(triple "${CMAKE_MATCH_1}-unknown-linux-${CMAKE_MATCH_3}")
  elseif(machine MATCHES "^riscv64-([a-z0-9]+-)?linux-(gnu|musl)$")
    set(triple "riscv64gc-unknown-linux-${CMAKE_MATCH_2}")
  endif()
  set(${result_triple} "${triple}" PARENT_SCOPE)
  set(${result_machine} "${machine}" PARENT_SCOPE)
endfunction()

if(NOT DEFINED CACHE{ASPERITY_RUST_TARGET})
  set(asperity_triple "$ENV{CARGO_BUILD_TARGET}")
  if(NOT asperity_triple AND CMAKE_CROSSCOMPILING)
    asperity_triple_of_compiler(asperity_triple asperity_machine)
    if(NOT asperity_triple)
      message(FATAL_ERROR "asperity: which Rust target is the machine '${asperity_machine}' of ${CMAKE_C_COMPILER}? "
                          "Set ASPERITY_RUST_TARGET to one of those that `rustc --print target-list` prints.")
    endif()
  elseif(NOT asperity_triple)
    execute_process(COMMAND "${ASPERITY_RUSTC}" -vV OUTPUT_VARIABLE asperity_triple)
    string(REGEX MATCH "host: ([^\r\n]+)" asperity_triple "${asperity_triple}")
    set(asperity_triple "${CMAKE_MATCH_1}")
  endif()
  set(ASPERITY_RUST_TARGET "${asperity_triple}" CACHE STRING "Rust target triple to build asperity for")
endif()

# ---- Where cargo writes ----
# A folder of its own: these libraries are linked with a soname, those of a plain `cargo build` are not.
if(DEFINED ENV{CARGO_TARGET_DIR})
  get_filename_component(asperity_target_dir "$ENV{CARGO_TARGET_DIR}/install" ABSOLUTE)
else()
  set(asperity_target_dir "${CMAKE_CURRENT_BINARY_DIR}/cargo")
endif()
set(ASPERITY_CARGO_DIR "${asperity_target_dir}/${ASPERITY_RUST_TARGET}/release")

# ---- File names ----
# ASPERITY_CARGO_*: as cargo writes them; ASPERITY_SHARED_FILE and its links: as they are installed.
if(ASPERITY_RUST_TARGET MATCHES "windows-msvc")
  set(ASPERITY_SHARED_FILE asperity.dll)
  set(ASPERITY_IMPORT_FILE asperity.dll.lib)
  set(ASPERITY_STATIC_FILE asperity.lib)
elseif(ASPERITY_RUST_TARGET MATCHES "windows")
  set(ASPERITY_SHARED_FILE asperity.dll)
  set(ASPERITY_IMPORT_FILE libasperity.dll.a)
  set(ASPERITY_STATIC_FILE libasperity.a)
elseif(ASPERITY_RUST_TARGET MATCHES "apple")
  set(ASPERITY_SHARED_FILE "libasperity.${PROJECT_VERSION}.dylib")
  set(ASPERITY_SHARED_LINKS "libasperity.${PROJECT_VERSION_MAJOR}.dylib" libasperity.dylib)
  set(ASPERITY_STATIC_FILE libasperity.a)
  set(ASPERITY_SONAME "@rpath/libasperity.${PROJECT_VERSION_MAJOR}.dylib")
  set(ASPERITY_SONAME_FLAG "-Wl,-install_name,${ASPERITY_SONAME}")
else()
  set(ASPERITY_SHARED_FILE "libasperity.so.${PROJECT_VERSION}")
  set(ASPERITY_SHARED_LINKS "libasperity.so.${PROJECT_VERSION_MAJOR}" libasperity.so)
  set(ASPERITY_STATIC_FILE libasperity.a)
  set(ASPERITY_SONAME "libasperity.so.${PROJECT_VERSION_MAJOR}")
  set(ASPERITY_SONAME_FLAG "-Wl,-soname,${ASPERITY_SONAME}")
endif()
if(ASPERITY_SHARED_LINKS)
  list(GET ASPERITY_SHARED_LINKS -1 ASPERITY_CARGO_SHARED)
else()
  set(ASPERITY_CARGO_SHARED "${ASPERITY_SHARED_FILE}")
endif()

# ---- System libraries that the static library needs ----
# rustc names those of its standard library when it links an empty crate; asperity adds none. Compilers add libgcc_s
# themselves, and its name would break `cc -static`.
set(asperity_probe "${CMAKE_CURRENT_BINARY_DIR}/native-static-libs")
file(WRITE "${asperity_probe}.rs" "")
execute_process(
  COMMAND "${ASPERITY_RUSTC}" --target "${ASPERITY_RUST_TARGET}" --crate-type staticlib
          "--print=native-static-libs=${asperity_probe}" -o "${asperity_probe}.a" "${asperity_probe}.rs"
  RESULT_VARIABLE asperity_probe_failed OUTPUT_QUIET ERROR_VARIABLE asperity_probe_message)
if(asperity_probe_failed)
  message(FATAL_ERROR "asperity: rustc cannot build for ${ASPERITY_RUST_TARGET}:\n${asperity_probe_message}")
endif()
file(STRINGS "${asperity_probe}" asperity_probe_libs)
separate_arguments(ASPERITY_NATIVE_LIBS NATIVE_COMMAND "${asperity_probe_libs}")
list(FILTER ASPERITY_NATIVE_LIBS EXCLUDE REGEX "^(-lgcc_s|/defaultlib:.*)$")
