from spack_repo.builtin.build_systems.makefile import MakefilePackage

from spack.package import *


class Asperity(MakefilePackage):
    """Friction laws from contact physics, callable from any solver. `spack dev-build` builds it from the sources that this
    recipe stands in."""

    license("MIT OR Apache-2.0")

    version("0.1.0")

    depends_on("c", type="build")
    depends_on("rust@1.85:", type="build")

    build_targets = ["package"]

    @property
    def install_targets(self):
        return ["install", f"PREFIX={self.prefix}"]
