"""The same questions on a user's own sensors and targets."""
