namespace pemesh { int PlaceholderFiltersGeometry() { return 0; } }
