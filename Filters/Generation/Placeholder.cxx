namespace pemesh { int PlaceholderFiltersGeneration() { return 0; } }
