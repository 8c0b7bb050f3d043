"""StringList, IntList, FloatList and their larger sisters."""
