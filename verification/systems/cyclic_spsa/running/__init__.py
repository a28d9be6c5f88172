"""What a simulated run was expected to do."""
