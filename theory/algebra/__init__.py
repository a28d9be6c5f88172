"""Mathematics that several systems share, each piece proved by an exact normal form."""
