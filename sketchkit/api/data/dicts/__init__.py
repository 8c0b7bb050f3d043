"""StringDict, IntDict, FloatDict and their larger sisters."""
