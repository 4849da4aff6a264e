# SPDX-License-Identifier: GPL-3.0-or-later
"""The tab Isolines of the 3D viewport's sidebar."""

import bpy

from .. import library
from ..blender.lines import result_objects
from ..blender.look import material
from ..language import counted, label
from .common import enum_name, write_sentence
from .field.presets_panel import DIRICHLET_PT_presets
from .lines.line_layout import draw_line_settings, draw_lock, properties
from .patches.lists import draw_patch_list
from .patches.tools import ADD_PATCH

_PATCH_LINES, _STATE_LINES = 2, 3  # that most sentences take, kept free for them: what is below does not jump


class _Panel:
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Isolines"

    @classmethod
    def poll(cls, context):
        obj = context.active_object
        return obj is not None and obj.type == "MESH" and not result_objects.is_result(obj)


class DIRICHLET_PT_patches(_Panel, bpy.types.Panel):
    bl_label = "Patches"

    @classmethod
    def poll(cls, context):
        obj = context.active_object  # the one that says what to do when there is no mesh
        return obj is None or not result_objects.is_result(obj)

    def draw(self, context):
        layout, obj = self.layout, context.active_object
        if library.failure():
            write_sentence(layout, context, library.failure(), "ERROR")
        if not _Panel.poll(context):
            layout.label(text="Select a mesh object", icon="INFO")
            return
        settings = obj.dirichlet
        draw_patch_list(layout, settings)
        if 0 <= settings.active_patch < len(settings.patches):
            _draw_patch(layout, context, settings.patches[settings.active_patch])
        column = layout.column(align=True)
        column.operator("wm.tool_set_by_id", text="Add Patch Tool", icon="MESH_CIRCLE").name = ADD_PATCH
        column.menu("DIRICHLET_MT_patches_from", icon="ADD")
        column.operator("dirichlet.patch_spread_values", icon="ARROW_LEFTRIGHT")


def _draw_patch(layout: bpy.types.UILayout, context: bpy.types.Context, patch: bpy.types.PropertyGroup) -> None:
    """What there is to say and set of the selected one."""
    if patch.problem:
        write_sentence(layout, context, patch.problem, "ERROR", _PATCH_LINES)
    else:
        sentence = (
            counted(patch.vertices, "1 vertex", "{count:,} vertices") if patch.vertices else label("Not counted yet")
        )
        write_sentence(layout, context, sentence, "CHECKMARK" if patch.vertices else "INFO", _PATCH_LINES)
    if not patch.weights_as_values:
        properties(layout).prop(patch, "value")


def _draw_state(layout: bpy.types.UILayout, context: bpy.types.Context, results: bpy.types.PropertyGroup) -> None:
    """What is to be known of the field."""
    sentence, icon = label("Not solved yet"), "INFO"
    if results.problem:
        sentence, icon = results.problem, "ERROR"
    elif results.solved:
        sentence, icon = label("{low:.6g} to {high:.6g}", low=results.minimum, high=results.maximum), "CHECKMARK"
    write_sentence(layout, context, sentence, icon, _STATE_LINES)


class DIRICHLET_PT_patch_options(_Panel, bpy.types.Panel):
    bl_label = "Patch Options"
    bl_parent_id = "DIRICHLET_PT_patches"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        obj = context.active_object
        settings = obj.dirichlet
        column = properties(self.layout)
        if 0 <= settings.active_patch < len(settings.patches):
            patch = settings.patches[settings.active_patch]
            column.prop_search(patch, "group", obj, "vertex_groups", text="Group")
            column.prop(patch, "weights_as_values", text="From Weights")
            column.separator()
        column.prop(settings, "threshold", slider=True)
        column.prop(settings, "overlap")
        self.layout.operator("dirichlet.check_patches", icon="VIEWZOOM")


class DIRICHLET_PT_field(_Panel, bpy.types.Panel):
    bl_label = "Field"

    def draw_header_preset(self, context):
        DIRICHLET_PT_presets.draw_panel_header(self.layout)

    def draw(self, context):
        layout, obj = self.layout, context.active_object
        settings = obj.dirichlet
        row = layout.split(factor=0.6, align=True)
        row.scale_y = 1.4
        row.operator("dirichlet.solve_field", icon="SHADING_RENDERED")
        row.prop(settings, "live", toggle=True, icon="REC" if settings.live else "RADIOBUT_OFF")
        _draw_state(layout, context, settings.results)
        properties(layout).prop(settings, "ramp_preset")
        ramp = material.find_ramp(obj)
        if not ramp:
            return
        layout.template_color_ramp(ramp, "color_ramp", expand=True)
        window = layout.column(align=True)
        window.enabled = settings.levels_mode != "LIST"
        window.prop(settings, "window_low_place", slider=True)
        window.prop(settings, "window_high_place", slider=True)
        window.prop(settings, "window_place", slider=True)
        if not window.enabled:
            write_sentence(layout, context, label("The levels are listed: no window chooses them"), "INFO")


class DIRICHLET_PT_field_options(_Panel, bpy.types.Panel):
    bl_label = "Field Options"
    bl_parent_id = "DIRICHLET_PT_field"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout, obj = self.layout, context.active_object
        column = properties(layout)
        column.prop(obj.dirichlet, "laplacian")
        column.prop(obj.dirichlet, "method")
        column.prop(obj.dirichlet, "use_modifiers")
        layout.operator("dirichlet.update_colors", icon="FILE_REFRESH")
        if material.hides_others(obj):
            layout.operator("dirichlet.restore_materials", icon="LOOP_BACK")


class DIRICHLET_PT_isolines(_Panel, bpy.types.Panel):
    bl_label = "Isolines"

    def draw(self, context):
        layout, settings = self.layout, context.active_object.dirichlet
        row = layout.row(align=True)
        row.scale_y = 1.4
        row.operator("dirichlet.make_isolines", icon="CURVE_DATA")
        bound = result_objects.find(context.active_object)
        if bound and bound.users_collection:  # not deleted by the user
            row.prop(bound.dirichlet_isolines, "follow", text="", icon="LINKED")
            draw_lock(row, bound.dirichlet_isolines)
        draw_line_settings(layout, settings, picking=True)


class DIRICHLET_PT_results(_Panel, bpy.types.Panel):
    bl_label = "Results"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context):
        return super().poll(context) and context.active_object.dirichlet.results.solved

    def draw(self, context):
        layout, results = self.layout, context.active_object.dirichlet.results
        rows = [
            (label("Connectivity"), f"{results.connectivity_ms:.2f} ms"),
            (label("Solver"), f"{results.solver_ms:.2f} ms"),
            (label("Isolines"), f"{results.isolines_ms:.2f} ms" if results.extracted else label("not made yet")),
            (label("Vertices"), f"{results.vertices:,}"),
            (label("Painted"), f"{results.painted:,}"),
            (label("Unknowns"), f"{results.unknowns:,}"),
            (label("Laplacian"), label(enum_name(results, "laplacian"))),
            (label("Residual"), f"{results.residual:.1e}"),
            (label("Field"), label("{low:.6g} to {high:.6g}", low=results.minimum, high=results.maximum)),
        ]
        if results.undefined:
            rows.append((label("Undefined"), f"{results.undefined:,}"))
        if results.extracted:
            levels = counted(results.levels, "1 level", "{count} levels")
            rows.append((label("Lines"), label("{lines} at {levels}", lines=results.lines, levels=levels)))
            rows.append((label("Closed / open"), f"{results.closed} / {results.lines - results.closed}"))
        table = layout.split(factor=0.45)
        names, numbers = table.column(align=True), table.column(align=True)
        for name, number in rows:
            names.label(text=name, translate=False)
            numbers.label(text=number, translate=False)
        warnings = [results.reason] if results.reason else []
        warnings += results.field_warnings.splitlines()
        warnings += results.isoline_warnings.splitlines() if results.extracted else []
        for warning in warnings:
            write_sentence(layout, context, warning, "INFO")


CLASSES = (
    DIRICHLET_PT_patches,
    DIRICHLET_PT_patch_options,
    DIRICHLET_PT_field,
    DIRICHLET_PT_field_options,
    DIRICHLET_PT_isolines,
    DIRICHLET_PT_results,
)
