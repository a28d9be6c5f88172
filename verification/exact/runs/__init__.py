"""Runs of the discontinuous laws, exactly."""
