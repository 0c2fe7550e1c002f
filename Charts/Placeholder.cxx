namespace pemesh { int PlaceholderCharts() { return 0; } }
