"""A tile in a tray: a simulated robot, a control model estimated from trials, and plans."""
