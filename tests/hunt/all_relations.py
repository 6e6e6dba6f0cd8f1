"""Every relation of the hunt by its name, in the order in which statements are given to them."""
from relations_measure import Sizes, Units
from relations_writing import Names, Order
from random_statements import made_statement  # noqa: F401

RELATIONS = {relation.name: relation for relation in (Units(), Sizes(), Order(), Names())}
