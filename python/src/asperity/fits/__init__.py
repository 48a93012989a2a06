"""Parameters from measured friction, and bands of friction, from many laws at a time."""
