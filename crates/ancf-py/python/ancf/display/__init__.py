"""Representations of objects: numbers with units, tables as text and as HTML."""
