# SPDX-License-Identifier: GPL-3.0-or-later
"""For Spack: the C and Fortran libraries by CMake, and the Python package as a variant."""

from spack.package import depends_on, extends, license, run_after, variant, version, when
from spack_repo.builtin.build_systems.cmake import CMakePackage


class Mdrcontact(CMakePackage):
    """Contact of coated, layered and graded bodies, computed in one dimension."""

    license("GPL-3.0-or-later")
    version("0.1.0")

    variant("python", default=True, description="Python package and command line")
    variant("openmp", default=True, description="Batches on several threads")

    depends_on("c", type="build")
    depends_on("fortran", type="build")
    depends_on("cmake@3.22:", type="build")
    depends_on("ninja", type="build")
    depends_on("gsl@2.5:")
    depends_on("lapack")
    depends_on("blas")

    with when("+python"):
        extends("python@3.10:")
        depends_on("py-pip", type="build")
        depends_on("py-scikit-build-core@0.10:", type="build")
        depends_on("py-numpy@2:", type=("build", "run"))
        depends_on("py-pint@0.20:", type="run")
        depends_on("py-tqdm@4.60:", type="run")
        depends_on("py-tomli@2:", type="run", when="^python@:3.10")

    def cmake_args(self):
        """Neither tests nor examples."""
        return [
            self.define("MDRCONTACT_BUILD_TESTS", False),
            self.define("MDRCONTACT_BUILD_EXAMPLES", False),
            self.define_from_variant("MDRCONTACT_OPENMP", "openmp"),
        ]

    @run_after("install")
    def install_python(self):
        """The Python package, from the same sources."""
        if self.spec.satisfies("+python"):
            python = self.spec["python"].command
            python("-m", "pip", "install", "--no-deps", "--no-build-isolation", "--prefix", self.prefix, self.stage.source_path)
