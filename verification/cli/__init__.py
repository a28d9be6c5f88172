"""The ``sensortrack`` command, one short file a sub-command."""
