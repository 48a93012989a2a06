"""Conan 2 recipe: builds from the sources that it lies in, with CMake and cargo. `conan create packaging/conan`."""

import re
from pathlib import Path

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeToolchain
from conan.tools.files import copy, rmdir


class Asperity(ConanFile):
    name = "asperity"
    description = "Friction laws from contact physics, callable from any solver"
    license = "MIT OR Apache-2.0"
    topics = ("friction", "contact", "tribology", "adhesion", "roughness")
    settings = "os", "arch", "compiler", "build_type"
    package_type = "library"
    options = {"shared": [True, False]}
    default_options = {"shared": False}
    languages = "C"

    def set_version(self):
        cargo = Path(self.recipe_folder, "..", "..", "Cargo.toml").read_text(encoding="utf-8")
        self.version = re.search(r'^version = "(.+)"', cargo, re.MULTILINE)[1]

    def export_sources(self):
        root = Path(self.recipe_folder, "..", "..")
        for pattern in (
            "CMakeLists.txt", "Cargo.*", "LICENSE*", "cmake/*", "src/*", "include/*", "fortran/asperity.f90",
        ):  # fmt: skip
            copy(self, pattern, str(root), self.export_sources_folder)

    def generate(self):
        CMakeToolchain(self).generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        # Conan writes its own; of the two libraries it keeps the one that was asked for.
        rmdir(self, str(Path(self.package_folder, "lib", "cmake")))
        rmdir(self, str(Path(self.package_folder, "lib", "pkgconfig")))
        unwanted = ("*.a", "asperity.lib") if self.options.shared else ("*.so*", "*.dylib", "*.dll", "*.dll.lib")
        for pattern in unwanted:
            for file in Path(self.package_folder).rglob(pattern):
                if not (self.options.shared and file.name.endswith(".dll.a")):
                    file.unlink()

    def package_info(self):
        self.cpp_info.libs = ["asperity"]
        self.cpp_info.set_property("cmake_target_name", "asperity::asperity")
        if self.settings.os == "Windows":
            self.cpp_info.libs = ["asperity.dll" if self.options.shared else "asperity"]
            if not self.options.shared:
                self.cpp_info.system_libs = ["kernel32", "ntdll", "userenv", "ws2_32", "dbghelp"]
        elif not self.options.shared and self.settings.os == "Linux":
            self.cpp_info.system_libs = ["m", "pthread", "dl"]
