"""What Coq says that a proof assumes."""

import re

# What Coq's standard library takes the real numbers, and Flocq their roundings, to be.
REALS = {
    "ClassicalDedekindReals.sig_not_dec",
    "ClassicalDedekindReals.sig_forall_dec",
    "FunctionalExtensionality.functional_extensionality_dep",
    "Classical_Prop.classic",
}


def axioms(printed):
    """The axioms in what Print Assumptions printed, of one statement or of several."""
    return set(re.findall(r"^([\w.]+)\s*:", printed, re.M)) - {"Axioms"}
