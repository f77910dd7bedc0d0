"""What is written at a place of a model, where it is described and where it is mentioned.

Nothing here knows a protocol or an editor: places are offsets into texts.
"""
