# SPDX-License-Identifier: GPL-3.0-or-later
"""The add-on's zips keep the rules that Blender and users rely on, and a zip that breaks one is refused by its name."""

import os
import sys
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "blender_scripts"))
import extension_rules as rules  # noqa: E402
import package_extension  # noqa: E402

VERSION = package_extension.project_version()
TAGS = ("cp311-cp311-manylinux_2_36_x86_64", "cp313-cp313-win_amd64", "cp314-cp314-macosx_11_0_arm64")


def wheel(folder, tag=TAGS[0], version=VERSION):
    target = folder / f"dirichlet_surface-{version}-{tag}.whl"
    with zipfile.ZipFile(target, "w") as archive:
        archive.writestr("dirichlet_surface/__init__.py", "")
        archive.writestr("dirichlet_surface/_native.so", "")
    return target


@pytest.fixture
def extension(tmp_path):
    """Packaged as for users, with wheels that hold nothing."""
    package_extension.make(tmp_path, [wheel(tmp_path, tag) for tag in TAGS], VERSION)
    return tmp_path / f"dirichlet_isolines-{VERSION}.zip"


def rewritten(archive, change):
    """A copy in which `change` has taken the texts of the files, by their names, and given others."""
    with zipfile.ZipFile(archive) as content:
        files = change({name: content.read(name) for name in content.namelist()})
    with zipfile.ZipFile(archive, "w") as content:
        for name, text in files.items():
            content.writestr(name, text)
    return archive


def replaced(name, old, new):
    def change(files):
        assert old in files[name]
        return files | {name: files[name].replace(old, new)}

    return change


def test_the_zips_keep_the_rules_and_say_their_platforms(extension):
    rules.check_extension(extension, VERSION)
    rules.check_legacy(extension.with_name(f"dirichlet_isolines-{VERSION}-legacy.zip"), VERSION)
    manifest = zipfile.ZipFile(extension).read("blender_manifest.toml").decode()
    assert 'platforms = ["linux-x64", "macos-arm64", "windows-x64"]' in manifest
    assert all(tag in manifest for tag in TAGS)


def test_the_same_input_gives_the_same_bytes(extension, tmp_path):
    again = tmp_path / "again"
    before = os.umask(0o077)
    try:
        package_extension.make(again, sorted(tmp_path.glob("*.whl")), VERSION)
    finally:
        os.umask(before)
    for made in again.glob("*.zip"):
        assert made.read_bytes() == (tmp_path / made.name).read_bytes()
    assert len(list(again.glob("*.zip"))) == 2


def test_without_a_wheel_for_its_python_there_is_no_legacy_zip(tmp_path):
    package_extension.make(tmp_path, [wheel(tmp_path, TAGS[1])], VERSION)
    assert [made.name for made in tmp_path.glob("*.zip")] == [f"dirichlet_isolines-{VERSION}.zip"]


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        (replaced("__init__.py", b'"name": "Dirichlet', b'"name": "Other'), "name differs"),
        (replaced("__init__.py", b'"version": (', b'"version": (7, '), "version differs"),
        (replaced("__init__.py", b'"category": "Mesh"', b'"category": "Paper"'), "category 'Paper' is none of"),
        (replaced("blender_manifest.toml", b"maintainer", b"owner"), "the manifest has no maintainer"),
        (replaced("blender_manifest.toml", b"SPDX:", b""), "no SPDX name"),
        (replaced("blender_manifest.toml", b"[build]", b"[permissions]\nnetwork = 'why'\n[build]"), "asks for network"),
        (replaced("blender_manifest.toml", b'"linux-x64", ', b""), "says platforms"),
        (replaced("blender_manifest.toml", b"cp314-cp314", b"cp315-cp315"), "the manifest lists the wheels"),
        (lambda files: files | {"ui/__pycache__/panels.pyc": b""}, "which nobody needs"),
        (lambda files: files | {"large": bytes(45_000_000)}, "bytes, more than 45000000"),
        (replaced("blender_manifest.toml", b'"4.2.0"', b'"4.2"'), "'4.2' is not of three numbers"),
        (replaced("blender_manifest.toml", b'"4.2.0"', b'"4.1.0"'), r"the earliest Blender is 4\.1\.0 in the manifest"),
        (replaced("__init__.py", b'"blender": (3, 4, 0)', b'"blender": (3, 3, 0)'), r"\(3, 3, 0\) in bl_info"),
        (replaced("blender_manifest.toml", b"[build]", b"website = 'http://a'\n[build]"), "does not begin with https"),
        (replaced("blender_manifest.toml", b'"*.pyc", ', b""), "leaves compiled or hidden files in"),
    ],
)
def test_what_breaks_a_rule_is_refused(extension, change, sentence):
    with pytest.raises(rules.RuleError, match=sentence):
        rules.check_extension(rewritten(extension, change), VERSION)


def test_two_wheels_for_one_python_and_platform_are_refused(tmp_path):
    older = "cp311-cp311-manylinux_2_28_x86_64"
    with pytest.raises(rules.RuleError, match="several wheels for cp311 on linux-x64"):
        package_extension.make(tmp_path, [wheel(tmp_path, TAGS[0]), wheel(tmp_path, older)], VERSION)


def test_a_wheel_that_holds_openmesh_holds_its_terms(tmp_path):
    made = wheel(tmp_path, TAGS[1])
    with zipfile.ZipFile(made, "a") as archive:
        archive.writestr("dirichlet_surface/libOpenMeshCore.so.9", "")
    with pytest.raises(rules.RuleError, match="whl holds OpenMesh without its terms"):
        package_extension.make(tmp_path, [made], VERSION)
    with zipfile.ZipFile(made, "a") as archive:
        archive.writestr("dirichlet_surface/licenses/OpenMesh.txt", "")
    package_extension.make(tmp_path, [made], VERSION)


def test_a_legacy_zip_that_holds_openmesh_holds_its_terms(extension):
    legacy = extension.with_name(f"dirichlet_isolines-{VERSION}-legacy.zip")
    with zipfile.ZipFile(legacy, "a") as archive:
        archive.writestr("dirichlet_isolines/dirichlet_surface/libOpenMeshCore.so.9", "")
    with pytest.raises(rules.RuleError, match=r"legacy\.zip holds OpenMesh without its terms"):
        rules.check_legacy(legacy, VERSION)


def test_the_legacy_zip_holds_the_library_for_this_platform(tmp_path, monkeypatch):
    tags = [f"cp311-cp311-{place}" for place in ("macosx_11_0_arm64", "manylinux_2_28_x86_64", "win_amd64")]
    wheels = [wheel(tmp_path, tag) for tag in tags]
    for here, made in [("linux-x86_64", 1), ("win-amd64", 2), ("macosx-11.0-arm64", 0)]:
        monkeypatch.setattr("sysconfig.get_platform", lambda here=here: here)
        assert package_extension.wheel_for_legacy(wheels) == wheels[made]
    assert package_extension.wheel_for_legacy([wheel(tmp_path, TAGS[1])]) is None


def test_the_legacy_zip_of_another_machine_takes_the_only_platform(tmp_path, monkeypatch):
    monkeypatch.setattr("sysconfig.get_platform", lambda: "plan-9")
    wheels = [wheel(tmp_path, tag) for tag in TAGS]
    assert package_extension.wheel_for_legacy(wheels) == wheels[0]
    assert package_extension.wheel_for_legacy([*wheels, wheel(tmp_path, "cp311-cp311-win_amd64")]) is None


def test_the_legacy_zip_may_hold_the_folder_that_delocate_makes(tmp_path):
    made = wheel(tmp_path, "cp311-cp311-macosx_11_0_arm64")
    with zipfile.ZipFile(made, "a") as archive:
        archive.writestr("dirichlet_surface/.dylibs/libOpenMeshCore.dylib", "")
        archive.writestr("dirichlet_surface/licenses/OpenMesh.txt", "")
    _, legacy = package_extension.make(tmp_path, [made], VERSION)
    assert "dirichlet_isolines/dirichlet_surface/.dylibs/libOpenMeshCore.dylib" in zipfile.ZipFile(legacy).namelist()


def test_the_changelog_has_the_version():
    assert f"\n## [{VERSION}] - 20" in (ROOT / "CHANGELOG.md").read_text()


def test_a_wheel_of_another_version_is_refused(tmp_path):
    with pytest.raises(rules.RuleError, match=r"wheel for cp313 has version 0\.0\.9"):
        package_extension.make(tmp_path, [wheel(tmp_path, TAGS[1], version="0.0.9")], VERSION)


@pytest.mark.parametrize(
    ("name", "sentence"),
    [
        ("dirichlet_surface.zip", "is no name of a wheel"),
        ("dirichlet_surface-1-py3-none-any.whl", "expected one version of CPython"),
        ("dirichlet_surface-1-cp311-cp311-any.whl", "no platform of Blender"),
    ],
)
def test_a_wheel_that_blender_could_not_choose_is_refused(name, sentence):
    with pytest.raises(rules.RuleError, match=sentence):
        rules.read_wheel_name(name)
