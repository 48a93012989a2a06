"""Height maps: read, cleaned, filtered, their summits and what these are worth. `asperity.surface` has the names."""
