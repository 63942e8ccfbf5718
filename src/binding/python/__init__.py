# SPDX-License-Identifier: Apache-2.0
"""Candela, a physically based renderer: candela.ri has the calls of the RenderMan Interface."""
