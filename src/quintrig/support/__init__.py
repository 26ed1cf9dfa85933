"""What everything stands on: arrays and their checks, errors, files, series, compilation, tolerances."""
