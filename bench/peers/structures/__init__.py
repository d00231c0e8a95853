"""Structures of many bodies, by ancf, EXUDYN and MuJoCo."""
