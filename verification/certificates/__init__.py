"""The format of certificates, their statements, and the checker that re-validates them."""
