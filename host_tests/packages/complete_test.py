#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""complete_test.py CMAKE SCRATCH: writes all packages and looks at each as its tool would.

All: the version is that of project(), nothing is left to fill in, and what includes or manifests name is there. Then manifests are parsed, and those that are
programs are run against stubs of their tools that note what they are told. Nothing lies at the root of the repository.
"""
import csv
import json
import pathlib
import re
import shutil
import subprocess
import sys
import types
import unittest
import xml.etree.ElementTree
import zipfile

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "platform" / "packages"))
import package  # noqa: E402

CMAKE, SCRATCH = sys.argv[1], pathlib.Path(sys.argv[2])
STUBS = pathlib.Path(__file__).resolve().parent / "stubs"
VERSION = package.bundle.project()["PROJECT_VERSION"]
UNITS = ["ingot_" + path.replace("/", "_") for path in package.bundle.sources()]


def folder_of(name):
    return SCRATCH / name / ("" if package.PACKAGES[name] == "" else "ingot")


def text_of(name, path):
    return (folder_of(name) / path).read_text(encoding="utf-8")


def told_by(script, **variables):
    """What a CMake file tells the stubs: {command: [its arguments, ...]}."""
    settings = [f"-D{key}={value}" for key, value in variables.items()]
    run = subprocess.run([CMAKE, f"-DFILE={script}", *settings, "-P", STUBS / "told.cmake"], capture_output=True, text=True, check=True)
    calls = {}
    for line in run.stderr.splitlines():
        command, *arguments = line.split(";")
        calls.setdefault(command, []).append(arguments)
    return calls


class Packages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        writer = package.Writer(SCRATCH)
        for name in package.PACKAGES:
            writer.write(name)

    def test_versions(self):
        numbers = dict(re.findall(r"#define INGOT_VERSION_(\w+) (\d+)", (ROOT / "kernel/base/version.h").read_text(encoding="utf-8")))
        self.assertEqual(".".join(numbers[part] for part in ("MAJOR", "MINOR", "PATCH")), VERSION, "kernel/base/version.h and project() of the root")
        said = {
            "arduino": re.search(r"^version=(.*)$", text_of("arduino", "library.properties"), re.M)[1],
            "platformio": json.loads(text_of("platformio", "library.json"))["version"],
            "esp_idf": re.search(r'^version: "(.*)"$', text_of("esp_idf", "idf_component.yml"), re.M)[1],
            "cmsis_pack": xml.etree.ElementTree.fromstring(text_of("cmsis_pack", "ingot.pdsc")).find("releases/release").get("version"),
            "meson": re.search(r"project\('ingot', 'cpp', version: '(.*?)'", text_of("meson", "meson.build"))[1],
            "xmake": re.search(r'set_version\("(.*)"\)', text_of("xmake", "xmake.lua"))[1],
            "vcpkg": json.loads(text_of("vcpkg", "vcpkg.json"))["version-semver"],
            "conan": re.search(r'^    version = "(.*)"$', text_of("conan", "conanfile.py"), re.M)[1],
            "pico": re.search(r"GIT_TAG v(\S+)\)", text_of("pico", "CMakeLists.txt"))[1],
        }
        self.assertEqual(said, dict.fromkeys(said, VERSION))
        self.assertEqual(set(package.PACKAGES) - set(said), {"zephyr", "consoles"}, "packages that have no version of their own")

    def test_one_place_of_the_version(self):
        for file in (ROOT / "platform/packages").rglob("*"):
            if file.is_file() and file.suffix != ".pyc" and VERSION in file.read_text(encoding="utf-8"):
                self.fail(f"{file.relative_to(ROOT)} has the version written in it")

    def test_guide_says_how_far_each_is_tried(self):
        with open(ROOT / "host_tests/tables/packages.csv", encoding="utf-8", newline="") as table:
            rows = list(csv.DictReader(line for line in table if not line.startswith("#")))
        folders = {path.name for path in (ROOT / "platform/packages").iterdir() if path.is_dir() and path.name != "__pycache__"}
        self.assertEqual({row["package"] for row in rows}, folders)
        for row in rows:
            self.assertIn(row["tried"], ("whole", "units", "layout"))
            by = (ROOT / "host_tests" / row["by"]).read_text(encoding="utf-8")
            self.assertIn({"pkg_config": "pkg-config", "c": "ingot_c"}.get(row["package"], row["package"]), by, row["by"])
            self.assertEqual(row["tried"] == "layout", row["by"] == "packages/complete_test.py", row["package"])

    def test_nothing_lies_at_the_root(self):
        manifests = ("library.properties", "library.json", "idf_component.yml", "zephyr", "Kconfig", "ingot.pdsc", "meson.build", "xmake.lua", "vcpkg.json",
                     "conanfile.py")
        self.assertEqual([name for name in manifests if (ROOT / name).exists()], [])

    def test_folders_are_complete(self):
        for name, kind in package.PACKAGES.items():
            to = folder_of(name)
            self.assertTrue((to / "LICENSE").is_file(), name)
            if kind in ("kept", "flat"):
                self.assertEqual(sorted(path.name for path in (to / "src/ingot").glob("*.cpp")), UNITS, name)
            if kind == "source":
                self.assertTrue((to / "source/kernel/CMakeLists.txt").is_file() and (to / "source/toolchains/flags.cmake").is_file(), name)
            for file in to.rglob("*"):
                if file.is_dir() or kind == "source" and "source" in file.relative_to(to).parts or file.suffix == ".pack":
                    continue
                text = file.read_text(encoding="utf-8")
                self.assertIsNone(re.search(r"@[A-Z_]+@", text), f"{file}: not filled in")
                for quoted in re.findall(r'^\s*#\s*include "([^"]+)"', text, re.M):
                    self.assertTrue((file.parent / quoted).is_file(), f"{file} includes {quoted}")

    def test_units_keep_the_contract(self):
        for name, kind in package.PACKAGES.items():
            for unit in UNITS if kind == "kept" else ():
                before = text_of(name, "src/ingot/" + unit).split('#include "ingot_stages.h"')[0]
                self.assertIn('\n#pragma GCC optimize("fp-contract=off", "no-math-errno")\n', before, f"{name}: {unit}")

    def test_arduino(self):
        fields = dict(line.split("=", 1) for line in text_of("arduino", "library.properties").splitlines())
        for field in ("name", "version", "author", "maintainer", "sentence", "paragraph", "category", "architectures", "includes"):
            self.assertTrue(fields[field], field)
        self.assertFalse({"*", "avr"} & set(fields["architectures"].split(",")))
        self.assertTrue((folder_of("arduino") / "src" / fields["includes"]).is_file())
        sketches = sorted(folder_of("arduino").glob("examples/*/*.ino"))
        self.assertTrue(sketches and all(path.stem == path.parent.name for path in sketches))
        self.assertEqual([path.read_bytes() for path in sketches], [path.read_bytes() for path in sorted(folder_of("platformio").glob("examples/*/*.ino"))])
        package.bundle.write_arduino(str(SCRATCH / "arduino_by_bundle"))  # what bundle.py --arduino does
        for file in (path for path in folder_of("arduino").rglob("*") if path.is_file()):
            self.assertEqual((SCRATCH / "arduino_by_bundle" / file.relative_to(folder_of("arduino"))).read_bytes(), file.read_bytes())

    def test_platformio(self):
        manifest = json.loads(text_of("platformio", "library.json"))
        self.assertNotIn("atmelavr", manifest["platforms"])
        for example in manifest["examples"]:
            for file in example["files"]:
                self.assertTrue((folder_of("platformio") / example["base"] / file).is_file(), file)
        self.assertTrue((folder_of("platformio") / manifest["build"]["srcDir"] / manifest["headers"]).is_file())

    def parsed_yaml(self, text):
        try:
            import yaml
        except ImportError:
            return None
        return yaml.safe_load(text)

    def test_esp_idf(self):
        told = told_by(folder_of("esp_idf") / "CMakeLists.txt", COMPONENT_LIB="lib")
        (registered,) = told["idf_component_register"]
        self.assertEqual([pathlib.Path(path).name for path in registered if path.endswith(".cpp")], UNITS)
        self.assertEqual(registered[-2:], ["INCLUDE_DIRS", "src"])
        self.assertIn("-std=gnu++17", told["target_compile_options"][0])
        manifest = self.parsed_yaml(text_of("esp_idf", "idf_component.yml"))
        self.assertTrue(manifest is None or manifest["version"] == VERSION and manifest["dependencies"]["idf"])

    def test_zephyr(self):
        module = self.parsed_yaml(text_of("zephyr", "zephyr/module.yml"))
        if module is not None:
            self.assertEqual(module["name"], "ingot")
            self.assertTrue((folder_of("zephyr") / module["build"]["cmake"] / "CMakeLists.txt").is_file() and (folder_of("zephyr") / module["build"]["kconfig"]).is_file())
        self.assertEqual(told_by(folder_of("zephyr") / "CMakeLists.txt"), {}, "it adds something where nobody asked for it")
        told = told_by(folder_of("zephyr") / "CMakeLists.txt", CONFIG_INGOT="y")
        self.assertEqual([pathlib.Path(path).name for path in told["zephyr_library_sources"][0]], UNITS)
        self.assertEqual(told["zephyr_include_directories"], [["src"]])
        self.assertRegex(text_of("zephyr", "Kconfig"), r'(?m)^config INGOT\n\tbool ".*"\n\tdepends on CPP ')

    def test_zephyr_kconfig(self):
        """Read by the library that Zephyr reads it with, where that is installed: ingot is to be had where C++17 is."""
        try:
            import kconfiglib
        except ImportError:
            self.skipTest("there is no kconfiglib")
        for has_cpp, has_17, gets in (("y", "y", "y"), ("y", "n", "n"), ("n", "n", "n")):
            above = SCRATCH / "Kconfig"
            above.write_text("".join(f"config {name}\n\tbool\n\tdefault {value}\n" for name, value in (("CPP", has_cpp), ("STD_CPP17", has_17)))
                             + f'source "{folder_of("zephyr") / "Kconfig"}"\n', encoding="utf-8")
            read = kconfiglib.Kconfig(str(above), warn=False)
            read.syms["INGOT"].set_value(2)
            self.assertEqual(read.syms["INGOT"].str_value, gets, f"CPP={has_cpp} STD_CPP17={has_17}")

    def test_vcpkg(self):
        told = told_by(folder_of("vcpkg") / "portfile.cmake", CURRENT_PACKAGES_DIR=SCRATCH / "nowhere")
        (configured,) = told["vcpkg_cmake_configure"]
        self.assertTrue((pathlib.Path(configured[configured.index("SOURCE_PATH") + 1]) / "CMakeLists.txt").is_file())
        self.assertTrue(pathlib.Path(told["vcpkg_install_copyright"][0][1]).is_file())
        helpers = {part["name"] for part in json.loads(text_of("vcpkg", "vcpkg.json"))["dependencies"]}
        self.assertEqual(helpers, {"vcpkg-cmake", "vcpkg-cmake-config"})

    def test_conan(self):
        class Toolchain:
            def __init__(self, _):
                self.cache_variables = {}

            def generate(self):
                told.update(self.cache_variables)

        told = {}
        stubs = {"conan": {"ConanFile": object}, "conan.tools": {}, "conan.tools.cmake": {"CMake": object, "CMakeToolchain": Toolchain, "cmake_layout": None}}
        for name, content in stubs.items():
            sys.modules[name] = types.ModuleType(name)
            vars(sys.modules[name]).update(content)
        recipe = {}
        exec(compile(text_of("conan", "conanfile.py"), "conanfile.py", "exec"), recipe)
        one = recipe["Ingot"]()
        for option, value in one.default_options.items():
            self.assertIn(value, one.options[option])
        one.options = types.SimpleNamespace(scalar="double", lanes=2)
        one.generate()
        root = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
        for variable in told:
            self.assertRegex(root, rf"(option|set)\({variable} ", "no such option")

    def test_meson_and_xmake(self):
        listed = re.findall(r"^  '(src/.*)',$", text_of("meson", "meson.build"), re.M)
        self.assertEqual(listed, ["src/ingot/" + unit for unit in UNITS])
        contract = re.search(r"set\(flags (-fno-fast-math .*)\)", (ROOT / "toolchains/flags.cmake").read_text(encoding="utf-8"))[1].split()
        for name, file in (("meson", "meson.build"), ("xmake", "xmake.lua")):
            flags = re.findall(r"['\"](-f[\w=-]+)['\"]", text_of(name, file))
            self.assertEqual(flags, contract, f"{name}: not the contract of toolchains/flags.cmake")

    def test_xmake(self):
        """Run by Lua, where that is installed, with functions that note what they are told in the place of xmake's: what each platform gets."""
        lua = shutil.which("lua5.4") or shutil.which("lua")
        if lua is None:
            self.skipTest("there is no Lua")
        for platform, architecture, lanes, flag in (("linux", "x86_64", "4", "-ffp-contract=off"), ("linux", "i386", "1", "-mfpmath=sse"),
                                                    ("linux", "riscv64", "1", "-ffp-contract=off"), ("windows", "x64", "1", "/fp:precise")):
            stubs = f"""
                local function among(mine, ...) for _, name in ipairs({{...}}) do if name == mine then return true end end return false end
                is_plat = function(...) return among("{platform}", ...) end
                is_arch = function(...) return among("{architecture}", ...) end
                setmetatable(_G, {{__index = function(_, name) return function(...) print(name, ...) end end}})
                dofile("{folder_of("xmake") / "xmake.lua"}")"""
            told = subprocess.run([lua, "-e", stubs], capture_output=True, text=True, check=True).stdout
            self.assertRegex(told, r"(?m)^target\tingot$")
            self.assertRegex(told, rf"(?m)^add_defines\tINGOT_LANES={lanes}\t")
            self.assertRegex(told, rf"(?m)^add_cxxflags\t.*{re.escape(flag)}\t")

    def test_cmsis_pack(self):
        pack = xml.etree.ElementTree.fromstring(text_of("cmsis_pack", "ingot.pdsc"))
        files = pack.findall("components/component/files/file")
        self.assertEqual([pathlib.Path(file.get("name")).name for file in files if file.get("category") == "sourceCpp"], UNITS)
        known = {condition.get("id") for condition in pack.findall("conditions/condition")}
        for component in pack.findall("components/component"):
            self.assertIn(component.get("condition"), known)
        with zipfile.ZipFile(SCRATCH / "cmsis_pack" / f"ingot.ingot.{VERSION}.pack") as archive:
            inside = set(archive.namelist())
        self.assertTrue({file.get("name") for file in files} <= inside | {"src/"} and {"ingot.pdsc", "LICENSE"} <= inside)

    def test_consoles(self):
        subprocess.run(["sh", "-n", folder_of("consoles") / "devkitpro.sh"], check=True)
        self.assertEqual(subprocess.run(["sh", folder_of("consoles") / "devkitpro.sh", "toaster"], capture_output=True, check=False).returncode, 2)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
