"""Decisions under uncertainty: distributions over states, and what plans do to them."""
