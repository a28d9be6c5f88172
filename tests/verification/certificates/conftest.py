"""The sample certificates and the committed statements, made once."""

import pytest

from verification.certificates.make import statements

from .samples import samples as all_samples


@pytest.fixture(scope="session")
def samples():
    return all_samples()


@pytest.fixture(scope="session")
def known():
    return statements()
