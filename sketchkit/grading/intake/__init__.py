"""Intake: what a class has handed in becomes folders of plain files, one for each submission.

`collect.py` goes through the folder, `unpack.py` and `copy.py` make the staged copies and refuse
what is hostile or broken, `entry.py` finds the sketch in them.
"""
