namespace pemesh { int PlaceholderIOMesh() { return 0; } }
