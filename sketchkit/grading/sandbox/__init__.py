"""The sandbox: a submission renders in a process of its own, behind as many walls as there are.

`job.py` says what is run and how it ended, `run.py` runs it, `level.py` finds out which walls this
computer has. The other modules are those walls; `start.py` and `inside.py` run behind them.
"""
