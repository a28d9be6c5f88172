"""A few sensors and targets, as a user types them."""

from hypothesis import strategies as st

PLAIN = {
    "sensors": [[0, 0], [300, 0], [0, 300], [300, 300]],
    "targets": [[100, 100], [200, 120], [150, 250]],
    "sigma_bearing_rad": "0.0087",
    "sigma_range_rel": "0.05",
    "n_max": 1,
    "m_max": 2,
    "beta": 10,
}


@st.composite
def networks(draw):
    """Sensors with even coordinates and targets with odd ones: none is upon another."""
    places = st.tuples(st.integers(-20, 20), st.integers(-20, 20))
    sensors = draw(st.lists(places, min_size=1, max_size=4, unique=True))
    targets = draw(st.lists(places, min_size=1, max_size=4, unique=True))
    return {
        "sensors": [[2 * x, 2 * y] for x, y in sensors],
        "targets": [[2 * x + 1, 2 * y + 1] for x, y in targets],
        "sigma_bearing_rad": "0.01",
        "sigma_range_rel": "0.05",
        "n_max": draw(st.integers(0, 3)),
        "m_max": draw(st.integers(1, 4)),
        "beta": draw(st.sampled_from(["1/2", "3"])),
        "reading": draw(st.sampled_from(["one", "two"])),
        "K": draw(st.sampled_from(["harmonic", "printed"])),
        "assignment": draw(st.sampled_from(["nearest", "best"])),
    }
