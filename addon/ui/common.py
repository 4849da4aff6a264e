# SPDX-License-Identifier: GPL-3.0-or-later
"""What several operators and panels need."""

from collections.abc import Iterator
from contextlib import contextmanager

import bpy

from .. import library
from ..blender.lines.result_objects import is_result
from ..blender.names import FIELD
from ..language import say
from ..sentences import told

_MODES = ("OBJECT", "PAINT_WEIGHT", "PAINT_VERTEX")


def poll_mesh(cls: type[bpy.types.Operator], context: bpy.types.Context, modes: tuple[str, ...] = _MODES) -> bool:
    """Whether the active object is a mesh that can be changed now; else says what to do."""
    obj = context.active_object
    if obj is None or obj.type != "MESH":
        cls.poll_message_set(say("Select a mesh object first"))
    elif context.mode not in modes:
        cls.poll_message_set(say("Go to Object, Weight Paint or Vertex Paint mode first"))
    elif not is_local(obj):
        cls.poll_message_set(say("The object is linked from another file: make it and its data local first"))
    else:
        return True
    return False


def is_local(obj: bpy.types.Object) -> bool:
    """Whether object and data are this file's own, to be changed."""
    return not any(block.library or block.override_library for block in (obj, obj.data))


def chosen_meshes(context: bpy.types.Context) -> list[bpy.types.Object]:
    """The active mesh object, then the others selected that can be changed, by name; results of ours are none."""
    active = context.active_object
    others = (obj for obj in context.selected_objects if obj.type == "MESH" and obj != active and is_local(obj))
    return [active, *sorted((obj for obj in others if not is_result(obj)), key=lambda obj: obj.name)]


def poll_patch(cls: type[bpy.types.Operator], context: bpy.types.Context) -> bool:
    """Whether a row of the list of patches is selected, given a mesh; else says what to do."""
    settings = context.active_object.dirichlet
    if 0 <= settings.active_patch < len(settings.patches):
        return True
    cls.poll_message_set(say("Select a patch in the list first"))
    return False


def poll_field(cls: type[bpy.types.Operator], context: bpy.types.Context) -> bool:
    """Whether the mesh carries a field; else says what to do."""
    if FIELD in context.active_object.data.attributes:
        return True
    cls.poll_message_set(say("Solve Field first"))
    return False


@contextmanager
def reporting(operator: bpy.types.Operator) -> Iterator[None]:
    """Reports a refusal as an error. Behind it, where nothing but a refusal leads, the operator is cancelled."""
    try:
        yield
    except library.refusals() as error:
        operator.report({"ERROR"}, told(error))


def report_made(operator: bpy.types.Operator, made) -> set[str]:
    """Reports summary and warnings of what was made; what the operator's execute returns."""
    if made.summary:
        operator.report({"INFO"}, made.summary)
    for warning in made.warnings:
        operator.report({"WARNING"}, warning)
    return {"FINISHED"}


def enum_name(group: bpy.types.PropertyGroup, name: str) -> str:
    """In English, what people see of the value of an enum."""
    return group.bl_rna.properties[name].enum_items[getattr(group, name)].name


def write_sentence(
    layout: bpy.types.UILayout, context: bpy.types.Context, sentence: str, icon: str, lines: int = 1
) -> None:
    """A sentence over as many lines as the sidebar's width asks for, and at least so many, so that what stands below
    it need not jump."""
    import textwrap  # when there is something to say: enabling the add-on need not wait for it

    characters = max(20, int(context.region.width / (7 * context.preferences.system.ui_scale)) - 6)
    column = layout.column(align=True)
    column.scale_y = 0.8
    wrapped = textwrap.wrap(sentence, characters)
    for k, line in enumerate(wrapped + [""] * (lines - len(wrapped))):
        column.label(text=line, icon=icon if k == 0 else "BLANK1")


def length(context: bpy.types.Context, value: float) -> str:
    """A length as number fields show it, by the scene's units."""
    units = context.scene.unit_settings
    return bpy.utils.units.to_string(units.system, "LENGTH", value * units.scale_length, precision=4).strip()
