"""What bounds and finds cuts: searches, routings, and short ways for some networks."""
