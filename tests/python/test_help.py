# SPDX-License-Identifier: GPL-3.0-or-later
"""What help() shows of the package is for reading."""

import inspect
import pydoc

import dirichlet_surface
import pytest

PUBLIC = [getattr(dirichlet_surface, name) for name in dirichlet_surface.__all__]


@pytest.mark.parametrize("thing", [thing for thing in PUBLIC if callable(thing)], ids=lambda thing: thing.__name__)
def test_help_names_types_by_their_short_names(thing):
    text = pydoc.render_doc(thing, renderer=pydoc.plaintext)
    assert "_SupportsArray" not in text
    assert "numpy._typing" not in text


def test_a_signature_is_no_longer_than_it_has_to_be():
    assert "vertices: 'ArrayLike'" in str(inspect.signature(dirichlet_surface.solve))
