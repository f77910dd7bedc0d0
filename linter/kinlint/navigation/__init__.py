"""Navigation in models: what is written at a place, and where it is described and mentioned.

Nothing here knows a protocol or an editor: places are offsets into texts.
"""
