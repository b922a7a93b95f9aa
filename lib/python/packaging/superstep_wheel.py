"""A build backend (PEP 517) of what CMake installs: needs Python, CMake and Ninja alone.

    pip wheel --no-deps lib/python                                          # builds in build/wheel
    pip wheel --no-deps --config-settings=build=build/release lib/python    # takes what is built there

The debian packages of the project have no other backend that drives CMake; this one does nothing else.
"""

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[3]


def get_requires_for_build_wheel(config_settings=None):
    return []


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    given = (config_settings or {}).get("build")
    build = pathlib.Path(given).resolve() if given else _built()
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    tag = f"{python}-{python}-{re.sub('[-.]', '_', sysconfig.get_platform())}"
    name = f"superstep-{_version()}"
    with tempfile.TemporaryDirectory() as prefix:
        _run("cmake", "--install", build, "--component", "python", "--prefix", prefix)
        package = next(pathlib.Path(prefix).rglob("superstep/__init__.py"), None)
        if package is None:
            raise RuntimeError(f"{build} has no Python module: CMake says why when it configures")
        files = {
            f"superstep/{path.name}": path.read_bytes() for path in sorted(package.parent.iterdir()) if path.is_file()
        }
    files[f"{name}.dist-info/METADATA"] = _metadata().encode()
    files[
        f"{name}.dist-info/WHEEL"
    ] = f"Wheel-Version: 1.0\nGenerator: superstep\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()
    wheel = f"{name}-{tag}.whl"
    with zipfile.ZipFile(os.path.join(wheel_directory, wheel), "w", zipfile.ZIP_DEFLATED) as archive:
        for path, content in files.items():
            archive.writestr(path, content)
        record = f"{name}.dist-info/RECORD"
        archive.writestr(record, "".join(map(_line_of_record, files.items())) + f"{record},,\n")
    return wheel


def build_sdist(sdist_directory, config_settings=None):
    raise RuntimeError("there is no archive of the Python package alone: it is built out of the whole project")


def _built():
    build = ROOT / "build" / "wheel"
    options = ["-DCMAKE_BUILD_TYPE=Release", "-DSUPERSTEP_TESTS=OFF", "-DSUPERSTEP_MICRO=OFF"]
    _run("cmake", "-S", ROOT, "-B", build, "-G", "Ninja", *options, f"-DSUPERSTEP_PYTHON_EXECUTABLE={sys.executable}")
    _run("cmake", "--build", build, "--target", "superstep_python")
    return build


def _run(*command):
    subprocess.run([os.fspath(part) for part in command], check=True, stdout=sys.stderr)


def _version():
    return re.search(r"project\(superstep VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


def _metadata():
    return (
        f"Metadata-Version: 2.1\nName: superstep\nVersion: {_version()}\n"
        "Summary: Which time integrator is fastest for heat and current in networks, and how far from the truth\n"
        "License: BSD-3-Clause\nRequires-Python: >=3.9\nRequires-Dist: numpy>=1.22\n"
        'Provides-Extra: jacobian\nRequires-Dist: scipy; extra == "jacobian"\n'
    )


def _line_of_record(item):
    path, content = item
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    return f"{path},sha256={digest},{len(content)}\n"
