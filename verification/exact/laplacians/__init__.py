"""The smallest eigenvalues of large sparse Laplacians."""
