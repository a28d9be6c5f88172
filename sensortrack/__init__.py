"""Runtime of SensorTrack: networks, data, kernels and errors; numpy and scipy are all it needs."""
