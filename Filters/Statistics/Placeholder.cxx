namespace pemesh { int PlaceholderFiltersStatistics() { return 0; } }
