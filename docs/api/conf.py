# SPDX-License-Identifier: GPL-3.0-or-later
"""Sphinx: the Python package's reference, out of its docstrings.

    ninja -C build/release python_docs
"""

import truelux

project = "truelux"
version = release = truelux.__version__
extensions = ["sphinx.ext.autodoc", "sphinx.ext.napoleon"]
# No page needs the network.
html_theme = "classic"
html_show_copyright = False
html_theme_options = {"nosidebar": True, "body_max_width": "52em"}
autodoc_member_order = "bysource"
autodoc_typehints = "none"
autodoc_mock_imports = []
napoleon_google_docstring = False
napoleon_use_rtype = False
napoleon_custom_sections = [("Warns", "Warns")]
