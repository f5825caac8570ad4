#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the packages: finished folders, each complete in itself, from the templates beside this file and the sources of the kernel.

    package.py --out <folder> [name...]          all of them, or those that are named; `cmake --build <build> --target package` writes <build>/packages

Manifests cannot lie at the root of the repository, where each tool looks for its own, so a folder here is what one hands to the tool, or publishes.
The version, the description and the address are those of project() in the CMakeLists.txt of the root. A run writes the same bytes again.
"""
import argparse
import pathlib
import shutil
import sys
import zipfile

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT / "toolchains"))
import bundle  # noqa: E402

# What each folder holds beside its manifests: `kept`, the flat form whose units keep the floating-point contract by themselves, as their tools give a
# user's unit no flag; `flat`, that whose units take it from flags, with the lanes that the build says; `source`, what CMake builds.
PACKAGES = {"arduino": "kept", "platformio": "kept", "esp_idf": "kept", "zephyr": "kept", "cmsis_pack": "kept", "meson": "flat", "xmake": "flat",
            "vcpkg": "source", "conan": "source", "pico": "", "consoles": ""}
SOURCES = ("CMakeLists.txt", "LICENSE", "CHANGELOG.md", "kernel", "platform", "toolchains")
ARDUINO_TOO = ("platformio",)  # takes the examples and the header at the top


class Writer:
    def __init__(self, out):
        self.out, self.units = out, {}
        self.values = bundle.project()

    def copy_bundle(self, kind, to):
        """One bundle of a kind is written, and copied from then on."""
        if kind not in self.units:
            first = to / "src" / "ingot"
            names = bundle.write_bundle(str(first), flat=True, keeps=True) if kind == "kept" else bundle.write_bundle(str(first), None, None, None, flat=True)
            self.units[kind] = (first, names)
            self.values["SOURCES_IN_QUOTES"] = "\n".join(f"  'src/ingot/{name}'," for name in names)
            self.values["SOURCES_AS_FILES"] = "\n".join(f'        <file category="sourceCpp" name="src/ingot/{name}"/>' for name in names)
        else:
            shutil.copytree(self.units[kind][0], to / "src" / "ingot")

    def manifests(self, folder, to):
        """Everything beside this file in `folder`: templates filled, others as they are."""
        for file in sorted(path for path in folder.rglob("*") if path.is_file()):
            target = to / file.relative_to(folder)
            target.parent.mkdir(parents=True, exist_ok=True)
            if file.suffix == ".in":
                target.with_suffix("").write_text(bundle.filled(file.read_text(encoding="utf-8"), self.values), encoding="utf-8", newline="\n")
            else:
                shutil.copyfile(file, target)

    def write(self, name):
        to = self.out / name / ("" if PACKAGES[name] == "" else "ingot")
        shutil.rmtree(self.out / name, ignore_errors=True)
        to.mkdir(parents=True)
        if PACKAGES[name] == "source":
            for part in SOURCES:
                (to / "source").mkdir(exist_ok=True)
                if (ROOT / part).is_dir():
                    shutil.copytree(ROOT / part, to / "source" / part, ignore=shutil.ignore_patterns("__pycache__"))
                else:
                    shutil.copyfile(ROOT / part, to / "source" / part)
        elif PACKAGES[name]:
            self.copy_bundle(PACKAGES[name], to)
        if name in ARDUINO_TOO:
            shutil.copytree(HERE / "arduino" / "examples", to / "examples")
            shutil.copyfile(HERE / "arduino" / "ingot.h", to / "src" / "ingot.h")
        self.manifests(HERE / name, to)
        if name == "arduino":
            (to / "ingot.h").rename(to / "src" / "ingot.h")
        shutil.copyfile(ROOT / "LICENSE", to / "LICENSE")
        if name == "cmsis_pack":
            self.zipped(to, self.out / name / f"ingot.ingot.{self.values['PROJECT_VERSION']}.pack")

    def zipped(self, folder, file):
        with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
            for path in sorted(path for path in folder.rglob("*") if path.is_file()):
                archive.writestr(zipfile.ZipInfo(str(path.relative_to(folder)), (1980, 1, 1, 0, 0, 0)), path.read_bytes(), zipfile.ZIP_DEFLATED)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", required=True, type=pathlib.Path)
    parser.add_argument("names", nargs="*", choices=[[], *PACKAGES], default=[], metavar="name")
    arguments = parser.parse_args()
    writer = Writer(arguments.out)
    for name in arguments.names or PACKAGES:
        writer.write(name)


if __name__ == "__main__":
    main()
