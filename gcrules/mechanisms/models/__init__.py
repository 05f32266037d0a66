"""Models as their makers ship them (URDF, SDF, MJCF): read to one neutral graph, and from it to a robot file."""
