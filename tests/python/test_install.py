"""What users install: by CMake, and as a wheel."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import zipfile

root = pathlib.Path(os.environ["SUPERSTEP_SOURCE_DIR"])
build = pathlib.Path(os.environ["SUPERSTEP_BUILD_DIR"])
USE = (
    "import superstep; s = superstep.Scene.from_edges([[0, 1]], 1.0, t_end=1.0); "
    "print(superstep.__file__, superstep.integrate(s).status)"
)


class Installations(unittest.TestCase):
    def works_from(self, folder: pathlib.Path):
        environment = {**os.environ, "PYTHONPATH": str(folder)}
        said = subprocess.run(
            [sys.executable, "-c", USE], env=environment, cwd="/", check=True, capture_output=True, text=True
        ).stdout
        self.assertEqual(said.split(), [str(folder / "superstep" / "__init__.py"), "ok"])
        self.assertTrue((folder / "superstep" / "py.typed").exists())
        self.assertTrue((folder / "superstep" / "_core.pyi").exists())

    def test_cmake_puts_the_package_where_interpreters_look(self):
        with tempfile.TemporaryDirectory() as prefix:
            subprocess.run(
                ["cmake", "--install", build, "--component", "python", "--prefix", prefix],
                check=True,
                stdout=subprocess.DEVNULL,
            )
            (package,) = pathlib.Path(prefix).rglob("superstep")
            self.assertIn(package.parent.name, ("dist-packages", "site-packages"))
            self.works_from(package.parent)

    def test_the_wheel_of_a_build(self):
        script = (
            f"import superstep_wheel, sys; print(superstep_wheel.build_wheel(sys.argv[1], {{'build': {str(build)!r}}}))"
        )
        with tempfile.TemporaryDirectory() as folder:
            packaging = {**os.environ, "PYTHONPATH": str(root / "lib" / "python" / "packaging")}
            name = subprocess.run(
                [sys.executable, "-B", "-c", script, folder], env=packaging, check=True, capture_output=True, text=True
            ).stdout.strip()
            with zipfile.ZipFile(pathlib.Path(folder) / name) as wheel:
                names = wheel.namelist()
                wheel.extractall(pathlib.Path(folder) / "unpacked")
                record = next(n for n in names if n.endswith("RECORD"))
                listed = [line.split(",")[0] for line in wheel.read(record).decode().splitlines()]
            self.assertEqual(sorted(listed), sorted(names))
            self.works_from(pathlib.Path(folder) / "unpacked")


if __name__ == "__main__":
    unittest.main()
