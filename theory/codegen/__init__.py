"""From laws to numeric source: scalar lines once, printed for each language."""
