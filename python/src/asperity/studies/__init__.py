"""Friction of many surfaces, and of single specimens. `asperity.study` has the names."""
