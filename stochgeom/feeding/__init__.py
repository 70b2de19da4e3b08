"""Feeding plans: preimages (phase I), plans (phase II), execution and verification."""
