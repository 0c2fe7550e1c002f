namespace pemesh { int PlaceholderFiltersMetrics() { return 0; } }
