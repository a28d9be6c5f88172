"""What the paper promises, in numbers and in pictures."""
