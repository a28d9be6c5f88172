"""Linear matrix inequalities: solved in floating point, their residuals computed by us."""
