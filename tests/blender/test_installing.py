# SPDX-License-Identifier: GPL-3.0-or-later
"""From an empty configuration to an empty one: what installing, upgrading, saving, disabling, removing leave behind."""

import json
import re

import archives
import bpy
import configuration
import pytest

BLENDER = bpy.app.binary_path
NEWER = "99.0.0"
BLENDERS_OWN = ("config/", "temporary/", "extensions/.cache/", "extensions/user_default/.blender_ext/")

SAVE = """
import bpy
obj = bpy.data.objects["Cube"]
for name, vertices in (("a", [0]), ("b", [7])):
    obj.vertex_groups.new(name=name).add(vertices, 1.0, "REPLACE")
    bpy.ops.dirichlet.patch_add_group(group=name)
obj.dirichlet.count = 7
bpy.ops.dirichlet.solve_field()
bpy.ops.dirichlet.make_isolines()
bpy.ops.wm.save_as_mainfile(filepath={file!r})
"""
LOOK = """
import addon_utils, bpy, json
bpy.ops.wm.open_mainfile(filepath={file!r})
obj = bpy.data.objects["Cube"]
def state():
    field = [item.value for item in obj.data.attributes["dirichlet_field"].data]
    lines = [[point.co[:] for point in spline.points] for spline in obj.dirichlet.isolines.data.splines]
    return [obj.dirichlet.count, [patch.group for patch in obj.dirichlet.patches], field, lines]
saved = state()
bpy.ops.dirichlet.solve_field()
bpy.ops.dirichlet.make_isolines()
enabled = [module for module in addon_utils.modules() if module.__name__ in bpy.context.preferences.addons.keys()]
module = next(module for module in enabled if "dirichlet_isolines" in module.__name__)
print("RESULT", json.dumps([saved, state(), addon_utils.module_bl_info(module)["version"]]))
"""
ABSENT = """
import bpy, sys
found = [*dir(bpy.types), *dir(bpy.types.Object), *bpy.context.preferences.addons.keys(), *sys.modules]
assert [name for name in found if "dirichlet" in name.lower()] == []
"""


@pytest.fixture
def archive(tmp_path):
    return archives.archive_for(BLENDER, tmp_path)


@pytest.fixture
def environment(tmp_path):
    """Of a Blender whose user saved the preferences once."""
    environment = configuration.empty(tmp_path / "home")
    configuration.run(BLENDER, environment, "import bpy; bpy.ops.wm.save_userpref()")
    return environment


@pytest.fixture
def look(environment, tmp_path):
    """What another process finds in the file that SAVE wrote: state as saved, made anew, and the add-on's version."""
    file = str(tmp_path / "saved.blend")

    def find():
        printed = configuration.run(BLENDER, environment, LOOK.format(file=file))
        saved, anew, version = json.loads(printed.partition("RESULT")[2].splitlines()[0])
        return saved, anew, ".".join(map(str, version))

    configuration.install(BLENDER, environment, archives.archive_for(BLENDER, tmp_path))
    configuration.run(BLENDER, environment, SAVE.format(file=file))
    return find


def files(environment):
    home = configuration.home_of(environment)
    return {str(path.relative_to(home)) for path in home.rglob("*") if path.is_file()}


@pytest.mark.skipif(bpy.app.version < (4, 2), reason="extensions came with 4.2")
@pytest.mark.skipif(BLENDER.endswith("/bpy"), reason="it has no command line")
def test_blender_finds_the_extension_valid(environment, archive):
    printed = configuration.extension(BLENDER, environment, "validate", str(archive))
    assert "Success" in printed
    assert not re.search("error|warning", printed, re.IGNORECASE), printed


def test_a_saved_file_opens_in_another_process_and_gives_the_same_again(look):
    saved, anew, _version = look()
    assert saved[:2] == [7, ["a", "b"]]
    assert len(saved[3]) >= 7
    assert saved == anew


def test_a_newer_version_over_it_keeps_it_enabled_and_opens_the_files(look, environment, tmp_path):
    before, _, version = look()
    assert version == archives.package_extension.project_version()
    configuration.install(BLENDER, environment, archives.make_archive_for(BLENDER, tmp_path / "newer", NEWER))
    saved, anew, version = look()
    assert version == NEWER
    assert saved == anew == before


def own(environment):
    """The add-on's files; where wheels are unpacked is Blender's, which clears it when an extension is disabled."""
    return {name for name in files(environment) if "dirichlet_isolines/" in name}


def test_disabled_and_enabled_again_it_opens_the_files(look, environment, archive):
    before = look()
    configuration.disable(BLENDER, environment, archive)
    configuration.enable(BLENDER, environment, archive)
    assert look() == before


def test_installing_using_disabling_and_removing_leaves_nothing_and_warns_of_nothing(environment, archive, tmp_path):
    before = files(environment)
    printed = [configuration.install(BLENDER, environment, archive)]
    printed.append(configuration.run(BLENDER, environment, SAVE.format(file=str(tmp_path / "saved.blend"))))
    used = own(environment)
    assert any(name.endswith("dirichlet_isolines/__init__.py") for name in used - before)
    printed.append(configuration.disable(BLENDER, environment, archive))
    printed.append(configuration.run(BLENDER, environment, ABSENT))
    assert own(environment) == used
    printed.append(configuration.enable(BLENDER, environment, archive))
    printed.append(configuration.remove(BLENDER, environment, archive))
    printed.append(configuration.run(BLENDER, environment, ABSENT))
    left = files(environment) - before
    assert {name for name in left if "dirichlet" in name or not name.startswith(BLENDERS_OWN)} == set()
    assert [text for text in printed if re.search("warn|error|leak", text, re.IGNORECASE)] == []


def test_starting_with_it_prints_what_starting_without_it_prints(environment, archive):
    def printed():
        text = configuration.run(BLENDER, environment, "import bpy; bpy.ops.wm.read_homefile()")
        return re.sub(r"^\d\d:\d\d\.\d{3} +", "", text, flags=re.MULTILINE)  # times of Blender's own log

    before = printed()
    configuration.install(BLENDER, environment, archive)
    assert printed() == before
    configuration.disable(BLENDER, environment, archive)
    assert printed() == before
    configuration.remove(BLENDER, environment, archive)
    assert printed() == before
