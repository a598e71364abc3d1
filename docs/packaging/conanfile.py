from conan import ConanFile
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout


class Denhartog(ConanFile):
    name = "denhartog"
    version = "0.2.0"
    license = "BSD-3-Clause"
    description = "Machine-verified reference for the forced vibration of damped systems with a Coulomb contact"
    settings = "os", "compiler", "build_type", "arch"
    exports_sources = "CMakeLists.txt", "src/*", "docs/*", "tests/conformance/vectors/*", "README.md", "LICENSE"
    requires = "eigen/3.4.0", "boost/1.83.0", "mpfr/4.2.1", "gmp/6.3.0", "nlohmann_json/3.11.3", "cli11/2.4.2"

    def layout(self):
        cmake_layout(self)

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["DENHARTOG_REFERENCE"] = False  # no package of Arb was looked for
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()

    def package_info(self):
        self.cpp_info.set_property("cmake_find_mode", "none")  # the project installs its own
        self.cpp_info.builddirs = ["lib/cmake/denhartog"]
