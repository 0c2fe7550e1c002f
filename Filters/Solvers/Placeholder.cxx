namespace pemesh { int PlaceholderFiltersSolvers() { return 0; } }
