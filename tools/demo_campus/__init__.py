"""Generator of the demo campus: models, textures and the campus description.

Standard library only, and the same bytes on every machine (see README.md in campus_assets/).
"""
