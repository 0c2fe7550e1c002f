namespace pemesh { int PlaceholderIOStudy() { return 0; } }
