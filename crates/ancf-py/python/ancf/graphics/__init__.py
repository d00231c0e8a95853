"""Plots and animations of results by matplotlib, and scenes in space by PyVista."""
