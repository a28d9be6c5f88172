"""Proof and confrontation: printed claims decided, with certificates."""
