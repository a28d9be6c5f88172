"""Where mean-square stability ends: limits of the step, and matrices that prove both sides."""
