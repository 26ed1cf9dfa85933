"""Hundreds of proofs on random nets: slow, and never contradicted by exact rational arithmetic."""

from test_proofs import never_contradicted


def test_many_random_nets_are_never_contradicted():
    told = never_contradicted(48, 14)
    assert told["proved"] > 60
    assert told["refuted"] > 60
