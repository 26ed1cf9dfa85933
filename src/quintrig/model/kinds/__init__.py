"""The kinds of surfaces that a model file may hold, one class each."""
