"""The constants of Assumptions 1 to 5 of a user's own costs."""
