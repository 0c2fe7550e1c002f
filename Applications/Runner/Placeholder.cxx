namespace pemesh { int PlaceholderRunner() { return 0; } }
