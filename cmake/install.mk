# make install   libraries, headers, asperity.pc, CMake package and Fortran source under $(DESTDIR)$(PREFIX)
# make package   what of that needs cargo; after it `make install` as root runs no compiler
# make uninstall removes what this version's `make install` has put under $(DESTDIR)$(PREFIX), and its own folders once they are empty
#
# LIBDIR, INCLUDEDIR and DATADIR default to lib, include and share under PREFIX. CARGO_TARGET_DIR and
# CARGO_BUILD_TARGET are honoured; any of these paths may have spaces. For Linux, other ELF systems and macOS; on Windows use CMake.

PREFIX ?= /usr/local
LIBDIR ?= $(PREFIX)/lib
INCLUDEDIR ?= $(PREFIX)/include
DATADIR ?= $(PREFIX)/share
CARGO ?= cargo
RUSTC ?= rustc
INSTALL ?= install

.PHONY: install package uninstall

empty :=
space := $(empty) $(empty)

asperity_version := $(shell sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml)
asperity_major := $(firstword $(subst ., ,$(asperity_version)))

# ---- Libraries ----
# In a folder of their own: these are linked with a soname, those of a plain `cargo build` are not, so that programs
# linked to target/release find libasperity.so by its plain name.
asperity_target_dir := $(if $(filter /%,$(firstword $(CARGO_TARGET_DIR))),,$(CURDIR)/)$(or $(CARGO_TARGET_DIR),target)/install
asperity_triple = $(or $(CARGO_BUILD_TARGET),$(shell $(RUSTC) -vV 2>/dev/null | sed -n 's/^host: //p'))
asperity_package := $(asperity_target_dir)/package$(addprefix -,$(CARGO_BUILD_TARGET))
asperity_static := $(asperity_package)/libasperity.a
# As rules name it.
asperity_made := $(subst $(space),\ ,$(asperity_static))

# Rust's name of the target if there is one, else the name of this system.
asperity_system := $(or $(CARGO_BUILD_TARGET),$(shell uname -s))
ifneq ($(findstring -windows-,$(asperity_system)),)
asperity_refusal = $(error make install knows no Windows; build for $(asperity_system) with CMake: docs/install.md)
endif
ifneq ($(findstring -apple-,$(asperity_system))$(filter Darwin,$(asperity_system)),)
asperity_shared := libasperity.$(asperity_version).dylib
asperity_links := libasperity.$(asperity_major).dylib libasperity.dylib
asperity_soname := @rpath/libasperity.$(asperity_major).dylib
asperity_soname_flag := -Wl,-install_name,$(asperity_soname)
else
asperity_shared := libasperity.so.$(asperity_version)
asperity_links := libasperity.so.$(asperity_major) libasperity.so
asperity_soname := libasperity.so.$(asperity_major)
asperity_soname_flag := -Wl,-soname,$(asperity_soname)
endif

package: $(asperity_made)

$(asperity_made): Cargo.toml Cargo.lock cmake/own_symbols.sh $(shell find src -name '*.rs')
	$(asperity_refusal)
	@cmake/check_rust.sh "$(CARGO)" "$(RUSTC)"
	$(CARGO) rustc --release --locked --lib --crate-type cdylib,staticlib \
	    --target $(asperity_triple) --target-dir "$(asperity_target_dir)" \
	    -- "--print=native-static-libs=$(asperity_target_dir)/$(asperity_triple)/native-static-libs" -C link-arg=$(asperity_soname_flag)
	mkdir -p "$(asperity_package)"
	$(RUSTC) --target $(asperity_triple) --print cfg > "$(asperity_package)/cfg"
	cp "$(asperity_target_dir)/$(asperity_triple)/native-static-libs" "$(asperity_package)"
	cp "$(asperity_target_dir)/$(asperity_triple)/release/$(lastword $(asperity_links))" \
	    "$(asperity_package)/$(asperity_shared)"
	cmake/own_symbols.sh "$(RUSTC)" "$(asperity_target_dir)/$(asperity_triple)/release/libasperity.a" "$(asperity_static)"

# ---- Generated files ----
# Paths in them start from the files themselves, unless LIBDIR lies outside PREFIX. Compilers add libgcc_s themselves,
# and its name would break `cc -static`.
# `^` marks where a path begins, as make's own functions of paths take a space for the end of one.
asperity_within = $(subst ^,,$(subst ^$(PREFIX)/,$(2)/,^$(1)))
asperity_libdir := $(subst ^,,$(subst ^$(PREFIX)/,,^$(LIBDIR)))
asperity_up := $(subst $(space),/,$(patsubst %,..,$(subst /, ,$(subst $(space),_,$(asperity_libdir)))))
ifeq ($(asperity_libdir),$(LIBDIR))
asperity_pc_prefix := $(PREFIX)
asperity_cmake_prefix := $(PREFIX)
else
asperity_pc_prefix := $${pcfiledir}/$(asperity_up)/..
asperity_cmake_prefix := $${_asperity_libdir}/$(asperity_up)
endif
# A space as asperity.pc has it, through sed.
asperity_escaped = $(subst $(space),\\ ,$(1))
asperity_native_libs = $(filter-out -lgcc_s,$(shell cat "$(asperity_package)/native-static-libs"))
asperity_pointer_bits = $(shell sed -n 's/^target_pointer_width="\(.*\)"/\1/p' "$(asperity_package)/cfg")

asperity_fill = sed \
    -e 's|@ASPERITY_VERSION@|$(asperity_version)|' \
    -e 's|@ASPERITY_VERSION_MAJOR@|$(asperity_major)|' \
    -e 's|@ASPERITY_POINTER_SIZE@|$(if $(filter 64,$(asperity_pointer_bits)),8,4)|' \
    -e 's|@ASPERITY_STATIC_FILE@|libasperity.a|' \
    -e 's|@ASPERITY_NATIVE_LIBS@|$(asperity_native_libs)|' \
    -e 's|@ASPERITY_CMAKE_NATIVE_LIBS@|$(subst $(space),;,$(asperity_native_libs))|' \
    -e 's|@ASPERITY_PC_PREFIX@|$(call asperity_escaped,$(asperity_pc_prefix))|' \
    -e 's|@ASPERITY_PC_LIBDIR@|$(call asperity_escaped,$(call asperity_within,$(LIBDIR),$${prefix}))|' \
    -e 's|@ASPERITY_PC_INCLUDEDIR@|$(call asperity_escaped,$(call asperity_within,$(INCLUDEDIR),$${prefix}))|' \
    -e 's|@ASPERITY_PC_DATADIR@|$(call asperity_escaped,$(call asperity_within,$(DATADIR),$${prefix}))|' \
    -e 's|@ASPERITY_CMAKE_PREFIX@|$(asperity_cmake_prefix)|' \
    -e 's|@ASPERITY_CMAKE_INCLUDEDIR@|$(call asperity_within,$(INCLUDEDIR),$${_asperity_prefix})|' \
    -e 's|@ASPERITY_CMAKE_DATADIR@|$(call asperity_within,$(DATADIR),$${_asperity_prefix})|' \
    -e 's|@ASPERITY_CMAKE_SHARED@|$${_asperity_libdir}/$(asperity_shared)|' \
    -e 's|@ASPERITY_CMAKE_LINK_PROPERTY@|IMPORTED_SONAME "$(asperity_soname)"|'

# ---- Rules ----
install: $(asperity_made)
	$(INSTALL) -d "$(DESTDIR)$(LIBDIR)/pkgconfig" "$(DESTDIR)$(LIBDIR)/cmake/asperity" "$(DESTDIR)$(INCLUDEDIR)" \
	    "$(DESTDIR)$(DATADIR)/asperity/fortran" "$(DESTDIR)$(DATADIR)/licenses/asperity"
	$(INSTALL) -m 755 "$(asperity_package)/$(asperity_shared)" "$(DESTDIR)$(LIBDIR)"
	for link in $(asperity_links); do ln -sf $(asperity_shared) "$(DESTDIR)$(LIBDIR)/$$link" || exit; done
	$(INSTALL) -m 644 "$(asperity_static)" "$(DESTDIR)$(LIBDIR)"
	$(INSTALL) -m 644 include/*.h include/*.hpp "$(DESTDIR)$(INCLUDEDIR)"
	$(INSTALL) -m 644 fortran/asperity.f90 "$(DESTDIR)$(DATADIR)/asperity/fortran"
	$(INSTALL) -m 644 LICENSE-MIT LICENSE-APACHE "$(DESTDIR)$(DATADIR)/licenses/asperity"
	@for file in asperity.pc asperity-config.cmake asperity-config-version.cmake; do \
	    $(asperity_fill) "cmake/$$file.in" > "$(asperity_package)/$$file" || exit; done
	$(INSTALL) -m 644 "$(asperity_package)/asperity.pc" "$(DESTDIR)$(LIBDIR)/pkgconfig"
	$(INSTALL) -m 644 "$(asperity_package)/asperity-config.cmake" "$(asperity_package)/asperity-config-version.cmake" \
	    "$(DESTDIR)$(LIBDIR)/cmake/asperity"

uninstall:
	for file in $(asperity_shared) $(asperity_links) libasperity.a pkgconfig/asperity.pc cmake/asperity/asperity-config.cmake \
	    cmake/asperity/asperity-config-version.cmake; do rm -f "$(DESTDIR)$(LIBDIR)/$$file" || exit; done
	for header in include/*.h include/*.hpp; do rm -f "$(DESTDIR)$(INCLUDEDIR)/$${header##*/}" || exit; done
	rm -f "$(DESTDIR)$(DATADIR)/asperity/fortran/asperity.f90" "$(DESTDIR)$(DATADIR)/licenses/asperity/LICENSE-MIT" \
	    "$(DESTDIR)$(DATADIR)/licenses/asperity/LICENSE-APACHE"
	-for folder in "$(LIBDIR)/cmake/asperity" "$(DATADIR)/asperity/fortran" "$(DATADIR)/asperity" "$(DATADIR)/licenses/asperity"; do \
	    [ ! -d "$(DESTDIR)$$folder" ] || rmdir "$(DESTDIR)$$folder"; done
