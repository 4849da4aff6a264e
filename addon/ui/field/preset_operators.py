# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators that hand settings on: from object to object, into presets and back."""

from pathlib import Path

import bpy
from bl_operators.presets import AddPresetBase
from bpy.props import BoolProperty, EnumProperty, StringProperty

from ...language import say
from ..common import is_local, poll_mesh, reporting
from .presets import PRESETS

SUBDIRECTORY = "dirichlet_isolines"  # of Blender's folders of presets


def _targets(context: bpy.types.Context) -> list[bpy.types.Object]:
    """The selected meshes beside the active one."""
    return [obj for obj in context.selected_objects if obj.type == "MESH" and obj != context.active_object]


class DIRICHLET_OT_copy_settings(bpy.types.Operator):
    bl_idname = "dirichlet.copy_settings"
    bl_label = "Copy Settings to Selected"
    bl_description = (
        "Give the other selected meshes the settings of field and lines of the active one, and the stops of its ramp. "
        "Their patches stay, and so do their results until they are computed anew"
    )
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        if not poll_mesh(cls, context):
            return False
        targets = _targets(context)
        if not targets:
            cls.poll_message_set(say("Select the meshes that are to get the settings, and last the one that has them"))
        elif not all(is_local(obj) for obj in targets):
            cls.poll_message_set(say("A selected mesh is linked from another file: make it and its data local first"))
        else:
            return True
        return False

    def execute(self, context):
        from ...blender import setups

        with reporting(self):
            setup = setups.read(context.active_object)
            for obj in _targets(context):
                setups.write(obj, setup)
            return {"FINISHED"}
        return {"CANCELLED"}


class DIRICHLET_OT_apply_preset(bpy.types.Operator):
    bl_idname = "dirichlet.apply_preset"
    bl_label = "Apply Preset"
    bl_description = "Give the object the settings of a preset, and its ramp the preset's stops"
    bl_options = {"REGISTER", "UNDO"}

    preset: EnumProperty(
        name="Preset",
        description="One of the presets that come with the add-on",
        items=[(name, preset.label, preset.description) for name, preset in PRESETS.items()],
    )
    filepath: StringProperty(
        name="File",
        description="A preset's file, in place of one that comes with the add-on",
        subtype="FILE_PATH",
        options={"SKIP_SAVE"},
    )

    @classmethod
    def description(cls, context, properties):
        return say(cls.bl_description if properties.filepath else PRESETS[properties.preset].description)

    @classmethod
    def poll(cls, context):
        return poll_mesh(cls, context)

    def execute(self, context):
        from ...blender import setups

        with reporting(self):
            setup = setups.load(Path(self.filepath)) if self.filepath else PRESETS[self.preset].setup
            setups.write(context.active_object, setup)
            return {"FINISHED"}
        return {"CANCELLED"}


class DIRICHLET_OT_preset_add(AddPresetBase, bpy.types.Operator):
    bl_idname = "dirichlet.preset_add"
    bl_label = "Add Preset"
    bl_description = "Keep all settings of the object and the stops of its ramp as a preset, or remove a preset"

    remove_name: BoolProperty(
        name="Remove", description="Remove the preset of that name", options={"HIDDEN", "SKIP_SAVE"}
    )
    remove_active: BoolProperty(
        name="Remove Active", description="Remove the preset used last", options={"HIDDEN", "SKIP_SAVE"}
    )

    preset_menu = "DIRICHLET_PT_presets"
    preset_subdir = SUBDIRECTORY

    @classmethod
    def poll(cls, context):
        return poll_mesh(cls, context)

    def execute(self, context):
        try:
            return super().execute(context)
        except OSError as error:
            self.report({"ERROR"}, say("The preset cannot be written: {reason}", reason=error))
            return {"CANCELLED"}

    def add(self, context, filepath):
        """Writes the file, for the base class."""
        from ...blender import setups

        setups.save(setups.read(context.active_object), Path(filepath))


CLASSES = (DIRICHLET_OT_copy_settings, DIRICHLET_OT_apply_preset, DIRICHLET_OT_preset_add)
